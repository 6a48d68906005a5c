// SPDX-License-Identifier: Apache-2.0
// The command line: every subcommand has a file of its own.
#include <spdlog/spdlog.h>

#include <iostream>
#include <opencv2/core/utils/logger.hpp>

#include "common.hpp"
#include "console.hpp"
#include "xgm/plugin/version.hpp"

namespace {

using namespace xgm::cli;

bool is_unknown(const CLI::App& app, const char* subcommand) {
  const auto has_the_name = [&](const CLI::App* known) { return known->check_name(subcommand); };
  return subcommand[0] != '-' && app.get_subcommands(has_the_name).empty();
}

std::string names_of_subcommands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* known : app.get_subcommands({})) names.push_back(known->get_name());
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("{} or {}", fmt::join(names, ", "), last);
}

/// What was asked for has to arrive: a full disk behind stdout is a failure.
int finish(int exit_code) {
  if (std::cout.flush()) return exit_code;
  spdlog::error("standard output cannot be written; check the free space");
  return exit_code == kOk ? kFailed : exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  set_up_logging("info");
  // What OpenCV has to say of unreadable files is said better by the errors of xgm.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  CLI::App app("Dense stereo matching by pipelines of plugins.", "pipeline");
  app.set_version_flag("--version", "xgm " XGM_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done; 1 the run failed or its map is empty; 2 usage or configuration (run: "
      "no image has been opened).");
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
  if (argc > 1 && is_unknown(app, argv[1])) {
    spdlog::error("there is no subcommand '{}'; choose {}", argv[1], names_of_subcommands(app));
    return kUsage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return finish(app.exit(error) == 0 ? kOk : kUsage);  // 0: help and version
  } catch (const UsageError& error) {
    spdlog::error(error.what());
    return kUsage;
  } catch (const std::exception& error) {
    spdlog::error(error.what());
    return kFailed;
  }
  return finish(call.exit_code);
}
