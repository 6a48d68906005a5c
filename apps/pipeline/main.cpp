// SPDX-License-Identifier: Apache-2.0
// The command line: every subcommand has a file of its own.
#include <malloc.h>
#include <CLI/CLI.hpp>

#include <spdlog/spdlog.h>

#include <cstdlib>
#include <iostream>
#include <new>
#include <opencv2/core/utils/logger.hpp>

#include "commands.hpp"
#include "terminal/console.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/simd.hpp"
#include "xgm/pipeline/lookup.hpp"
#include "xgm/plugin/version.hpp"

namespace {

using namespace xgm;
using namespace xgm::cli;

/// A misspelt name is told before the parser complains of what follows from it.
void require_known_names(const CLI::App& app, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().starts_with('-')) return;
  std::vector<std::string> subcommands;
  for (const CLI::App* known : app.get_subcommands({})) subcommands.push_back(known->get_name());
  require_name("subcommand", arguments.front(), subcommands);

  std::vector<std::string> options;
  for (const CLI::Option* known : app.get_subcommand(arguments.front())->get_options()) {
    for (const std::string& name : known->get_lnames()) options.push_back("--" + name);
  }
  for (const std::string& argument : arguments) {
    if (argument == "--") return;
    if (argument.starts_with("--")) {
      require_name("option", argument.substr(0, argument.find('=')), options);
    }
  }
}

/// What was asked for has to arrive: a full disk behind stdout is a failure.
int finish(int exit_code) {
  if (std::cout.flush()) return exit_code;
  spdlog::error("standard output cannot be written; check the free space");
  return exit_code == kOk ? kFailed : exit_code;
}

/// For the next image or map: memory from the system has to be cleared first, page by page. What is
/// larger is a volume, which xgm::new_buffer() keeps, or OpenCV's.
void keep_freed_memory() {
  constexpr int kLargeMap = 128 << 20;
  mallopt(M_MMAP_THRESHOLD, kLargeMap);
  mallopt(M_TRIM_THRESHOLD, 4 * kLargeMap);
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  set_up_logging("info");
  // What OpenCV has to say of unreadable files is said better by the errors of xgm.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  CLI::App app("Dense stereo matching by pipelines of plugins.", "pipeline");
  app.set_version_flag("--version", "xgm " XGM_VERSION);
  app.require_subcommand(1);
  app.footer("Exit codes: 0 done; 1 the run failed or its map is empty; 2 usage or configuration.");
  std::optional<SimdChoice> simd;  // of this thread, which makes all runs
  Invocation call{{argv + 1, argv + argc}};
  add_run(app, call);
  add_eval(app, call);
  add_check(app, call);
  add_list(app, call);
  add_describe(app, call);
  add_graph(app, call);
  add_schema(app, call);
  add_bench(app, call);
  add_scenes(app, call);
  add_synth(app, call);
  add_explain(app, call);
  add_plan(app, call);
  add_speed(app, call);
  try {
    if (const char* target = std::getenv("XGM_SIMD")) simd.emplace(target);
    require_known_names(app, call.arguments);
  } catch (const Error& error) {
    spdlog::error(error.what());
    return kUsage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return finish(app.exit(error) == 0 ? kOk : kUsage);  // 0: help and version
  } catch (const UsageError& error) {
    spdlog::error(error.what());
    return kUsage;
  } catch (const std::bad_alloc&) {
    spdlog::error("not enough memory; use smaller images");
    return kFailed;
  } catch (const std::exception& error) {
    spdlog::error(error.what());
    return kFailed;
  }
  return finish(call.exit_code);
}
