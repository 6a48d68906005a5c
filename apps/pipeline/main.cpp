// SPDX-License-Identifier: Apache-2.0
// The command line: every subcommand has a file of its own.
#include <malloc.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <new>
#include <opencv2/core/utils/logger.hpp>

#include "commands.hpp"
#include "terminal/console.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/simd.hpp"

namespace {

using namespace xgm;
using namespace xgm::cli;

/// What was asked for has to arrive: a full disk behind stdout is a failure.
int finish(int exit_code) {
  if (std::cout.flush()) return exit_code;
  log_error("standard output cannot be written; check the free space");
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
  std::signal(SIGXFSZ, SIG_IGN);  // a file larger than allowed is an error of its writing
  set_up_logging("info");
  // What OpenCV has to say of unreadable files is said better by the errors of xgm.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  std::optional<SimdChoice> simd;  // of this thread, which makes all runs
  CommandLine line(argc, argv);
  add_run(line);
  add_eval(line);
  add_check(line);
  add_list(line);
  add_describe(line);
  add_graph(line);
  add_schema(line);
  add_bench(line);
  add_scenes(line);
  add_synth(line);
  add_explain(line);
  add_plan(line);
  add_speed(line);
  add_tiles(line);
  add_diff(line);
  add_tune(line);
  add_new_plugin(line);
  add_check_plugin(line);
  add_doctor(line);
  try {
    if (const char* target = std::getenv("XGM_SIMD")) simd.emplace(target);
    return finish(line.run());
  } catch (const UsageError& error) {
    log_error(error.what());
    return kUsage;
  } catch (const std::bad_alloc&) {
    log_error("not enough memory; use smaller images");
  } catch (const std::exception& error) {
    log_error(error.what());
  }
  return kFailed;
}
