// SPDX-License-Identifier: Apache-2.0
// pipeline diff: what do two runs have differently?
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "xgm/base/error.hpp"
#include "xgm/evaluation/run_diff.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/output_folder.hpp"

namespace xgm::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kSame = 0, kDifferent = 1;

struct Options {
  std::string first, second, output;
  double threshold = 0;
};

std::string picture_file(const Options& options) {
  return (fs::path(options.output) / "difference.png").string();
}

void write_picture(const Options& options) {
  write_png(picture_file(options),
            difference_picture(read_map_of_run(options.first), read_map_of_run(options.second),
                               options.threshold));
  std::cout << "written: " << picture_file(options) << '\n';
}

int diff(const Options& options) {
  if (!(options.threshold >= 0)) throw UsageError("--threshold: give px from 0 on");
  try {
    if (!options.output.empty()) make_output_folder(options.output, "--output ");
    const RunDiff diff = compare_runs(options.first, options.second, options.threshold);
    std::cout << diff_text(diff);
    if (!options.output.empty() && diff.map) write_picture(options);
    return diff.same() ? kSame : kDifferent;
  } catch (const Error& error) {
    throw UsageError(error.what());  // 1 says that they differ
  }
}

}  // namespace

void add_diff(CommandLine& line) {
  auto options = std::make_shared<Options>();
  Command command =
      line.add("diff", "Compare two runs: configuration, program, inputs, and the map",
               [options] { return diff(*options); });
  command.option("first", options->first, "Output folder of a run").type_name("RUN_A").required();
  command.option("second", options->second, "Output folder of another run")
      .type_name("RUN_B")
      .required();
  command
      .option("--threshold", options->threshold,
              "Disparities differ if they do by more than this, px")
      .type_name("PX")
      .show_default();
  command
      .option("-o,--output", options->output,
              "Also write difference.png to this folder: where the maps differ, and by how much")
      .type_name("DIR");
  command.footer("Exit codes: 0 the runs are the same; 1 they differ; 2 they cannot be compared.");
}

}  // namespace xgm::cli
