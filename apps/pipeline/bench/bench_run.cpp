// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_run.hpp"

#include <spdlog/fmt/fmt.h>

#include <filesystem>
#include <iostream>

#include "commands.hpp"
#include "terminal/console.hpp"
#include "xgm/io/file.hpp"

namespace xgm::cli {

std::unique_ptr<FolderLock> hold_output(const BenchOptions& options) {
  return before_any_run([&] {
    make_output_folder(options.output, "--output ");
    return std::make_unique<FolderLock>(options.output);
  });
}

std::vector<std::string> run_words(const BenchOptions& options, int threads,
                                   const BenchPipeline& pipeline, const std::string& folder,
                                   const std::vector<std::string>& input) {
  std::vector<std::string> words{"pipeline", "run"};
  // With "=", for values may begin with a dash.
  const auto add = [&](const std::string& option, const std::string& value) {
    words.push_back(option + "=" + value);
  };
  add("--output", folder);
  add("--threads", std::to_string(threads));
  add("--log-level", "warning");
  if (!options.memory_limit.empty()) add("--memory-limit", options.memory_limit);
  for (const Override& change : pipeline.overrides) {
    add("--set", change.path + "=" + change.value);
  }
  for (const std::string& file : options.plugins.files) add("--plugin", file);
  words.insert(words.end(), input.begin(), input.end());
  return words;
}

void tell(const BenchProgress& at, Progress& progress) {
  const std::string left =
      at.seconds_left > 0 ? ", about " + duration_text(at.seconds_left) + " left" : "";
  const std::string what =
      fmt::format("run {} of {}{}: {} on {}", at.number, at.total, left, at.pipeline, at.scene);
  if (!at.finished) {
    progress.begin(what);
  } else if (!at.figures.failure.empty()) {
    log_warning(what + " failed: " + at.figures.failure);
  } else {
    log_info(fmt::format("{}: {:.2f} s, {:.0f} MB", what, at.figures.seconds,
                         at.figures.peak_bytes / 1e6));
  }
}

void write_tables(const std::string& summary, const std::vector<BenchFile>& files,
                  Progress& progress) {
  progress.end();
  std::cout << summary << std::flush;
  progress.begin("writing the tables");
  std::string written = "written:";
  for (const BenchFile& file : files) {
    write_file(file.file, file.text());
    written += ' ' + file.file;
  }
  progress.end();
  std::cout << written << std::endl;
}

int exit_code(bool interrupted, std::size_t failures) {
  if (!interrupted) return failures == 0 ? kOk : kFailed;
  log_warning("interrupted; the same command goes on from here");
  return kSignalled + Interruptible::signal();
}

}  // namespace xgm::cli
