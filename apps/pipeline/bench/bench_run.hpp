// SPDX-License-Identifier: Apache-2.0
// What benches of all kinds of pipelines do alike.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/bench_options.hpp"
#include "terminal/progress.hpp"
#include "xgm/base/error.hpp"
#include "xgm/evaluation/bench_process.hpp"
#include "xgm/io/output_folder.hpp"

namespace xgm::cli {

// Also after it has been built anew, this is what runs.
inline constexpr const char* kThisProgram = "/proc/self/exe";

/// What `body` returns; what it throws, a user can mend before any run.
template <class Body>
auto before_any_run(const Body& body) {
  try {
    return body();
  } catch (const UsageError&) {
    throw;
  } catch (const Error& error) {
    throw UsageError(error.message());
  }
}

/// Makes the output folder, and keeps other benches out of it.
std::unique_ptr<FolderLock> hold_output(const BenchOptions& options);

/// The command line of a run of a pipeline: `input` says on what. File names may begin with a dash.
std::vector<std::string> run_words(const BenchOptions& options, int threads,
                                   const BenchPipeline& pipeline, const std::string& folder,
                                   const std::vector<std::string>& input);

/// Says where the bench stands: on the line that is rewritten, and in one that stays.
void tell(const BenchProgress& at, Progress& progress);

struct BenchFile {
  std::string file;
  std::function<std::string()> text;
};
/// Prints `summary`, then writes the tables. Nothing is printed while the line of the progress
/// stands on the terminal.
void write_tables(const std::string& summary, const std::vector<BenchFile>& files,
                  Progress& progress);

/// What the program returns; a failure counts more than nothing, an interruption more than that.
int exit_code(bool interrupted, std::size_t failures);

}  // namespace xgm::cli
