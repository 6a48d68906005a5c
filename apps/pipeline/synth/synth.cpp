// SPDX-License-Identifier: Apache-2.0
// pipeline synth: make scenes whose truth is known.
#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "options/scene_options.hpp"
#include "options/values.hpp"
#include "synth/synth_satellite.hpp"
#include "terminal/progress.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/evaluation/bench_process.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/synthesis/generate.hpp"

namespace xgm::cli {
namespace {

namespace fs = std::filesystem;

struct SynthOptions {
  std::string folder;
  int count = 1;
  std::string size;
  std::string disparities = "0:63";
  std::uint64_t seed = 1;
  int objects = 12;
  std::vector<std::string> faults;
  int bits = 8;
  bool grey = false;
  bool force = false;
  int threads = 0;
  SatelliteOptions satellite;
};

cv::Size parse_size(const std::string& text) {
  constexpr double kMaxPixels = 400e6;
  int width = 0, height = 0, end = 0;
  const int found = std::sscanf(text.c_str(), "%6dx%6d%n", &width, &height, &end);
  const bool whole = found == 2 && end == static_cast<int>(text.size());
  if (!whole || width < 1 || height < 1 || static_cast<double>(width) * height > kMaxPixels)
    throw UsageError("--size " + text +
                     ": write WIDTHxHEIGHT in px, at most 400 million in all, "
                     "for example 640x480");
  return {width, height};
}

synthesis::Options parse(const SynthOptions& options) {
  synthesis::Options parsed;
  parsed.size = parse_size(options.size.empty() ? "640x480" : options.size);
  parsed.disparities = parse_disparities(options.disparities);
  parsed.objects = options.objects;
  parsed.colour = !options.grey;
  parsed.bits = options.bits;
  try {
    for (const std::string& fault : options.faults) synthesis::plant(parsed.faults, fault);
  } catch (const Error& error) {
    throw UsageError("--fault: " + error.message());
  }
  return parsed;
}

void prepare_folder(const SynthOptions& options) {
  std::error_code failure;
  const fs::path folder(options.folder);
  make_output_folder(options.folder);
  const bool empty = fs::is_empty(folder, failure);
  if (failure) throw UsageError(options.folder + ": cannot be read: " + failure.message());
  if (!empty && !options.force)
    throw UsageError(options.folder +
                     ": is not empty; choose another folder, or add --force to "
                     "replace scenes of the same names");
}

std::string scene_name(int number) { return fmt::format("scene_{:04d}", number); }

int satellite_size(const std::string& text) {
  if (text.empty()) return 1000;
  const auto side = parse_number(text);
  if (side && *side == std::floor(*side) && *side >= 64 && *side <= 20000) {
    return static_cast<int>(*side);
  }
  throw UsageError("--size " + text +
                   ": satellite images are square; write one number of px from 64 to 20000, for "
                   "example 1000");
}

/// Returns the signal that asked for the program's end meanwhile.
int synth_satellites(const SynthOptions& options) {
  const int size = satellite_size(options.size);
  check_satellites(options.satellite, size, options.seed);
  prepare_folder(options);
  const ThreadLimit threads(options.threads);
  Progress progress;
  for (int i = 0; i < options.count; ++i) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(i);
    const std::string folder = (fs::path(options.folder) / scene_name(i + 1)).string();
    progress.begin(fmt::format("scene {} of {}", i + 1, options.count));
    const Interruptible interruptible;
    const std::string made = write_satellites(folder, options.satellite, size, seed);
    progress.end();
    std::cout << folder << ": seed " << seed << ", " << made << std::endl;
    if (const int signal = Interruptible::signal()) return kSignalled + signal;
  }
  return kOk;
}

std::string percent_hidden(const cv::Mat1b& non_occluded) {
  const double seen = cv::countNonZero(non_occluded) / static_cast<double>(non_occluded.total());
  return fmt::format("{:.1f} %", 100 * (1 - seen));
}

/// A scene whose writing has begun is written to its end: nothing half done is left. Returns the
/// signal that asked for the program's end meanwhile, 0 if there was none.
int write_to_end(const fs::path& folder, const synthesis::GeneratedScene& scene,
                 const synthesis::Options& wanted) {
  const Interruptible interruptible;
  synthesis::write_scene(folder.string(), scene, wanted);
  return Interruptible::signal();
}

int synth(const SynthOptions& options) {
  if (options.satellite.satellite) return synth_satellites(options);
  synthesis::Options wanted = parse(options);
  prepare_folder(options);
  const ThreadLimit threads(options.threads);
  Progress progress;
  for (int i = 0; i < options.count; ++i) {
    wanted.seed = options.seed + static_cast<std::uint64_t>(i);
    const fs::path folder = fs::path(options.folder) / scene_name(i + 1);
    progress.begin(fmt::format("scene {} of {}", i + 1, options.count));
    const synthesis::GeneratedScene scene = synthesis::generate(wanted);
    if (const int signal = write_to_end(folder, scene, wanted)) return kSignalled + signal;
    progress.end();
    std::cout << folder.string() << ": seed " << wanted.seed << ", "
              << percent_hidden(scene.non_occluded) << " hidden in the right view" << std::endl;
  }
  if (wanted.disparities.begin < 0)
    std::cout << "calib.txt cannot express negative disparities: run these scenes with "
                 "--disparities "
              << options.disparities << std::endl;
  return kOk;
}

/// All faults with their values, as they are if none are given.
std::string fault_help() {
  std::string text =
      "Faults of --fault NAME[=VALUE[,VALUE...]], with what they are if no value is given:\n";
  for (const synthesis::FaultKind& kind : synthesis::fault_kinds()) {
    std::string values, names;
    for (const synthesis::FaultValue& value : kind.values) {
      values += fmt::format("{}{:g}", values.empty() ? "=" : ",", value.planted);
      names += fmt::format("{}{} {:g} to {:g}{}{}", names.empty() ? "" : "; ", value.name,
                           value.minimum, value.maximum, value.unit.empty() ? "" : " ", value.unit);
    }
    text += fmt::format("  {:<24}{}\n{:26}({})\n", kind.name + values, kind.text, "", names);
  }
  return text;
}

void add_scene_options(Command command, SynthOptions& options) {
  constexpr int kMaxScenes = 1'000'000;
  command.option("--count", options.count, "Number of scenes; each has the next seed")
      .type_name("N")
      .range(1, kMaxScenes)
      .show_default();
  command.option("--size", options.size, "Size of the images, px; N with --satellite (1000)")
      .type_name("WxH")
      .show_default("640x480");
  command
      .option("--disparities", options.disparities,
              "Smallest and largest disparity there may be, px; may be negative")
      .type_name("MIN:MAX")
      .show_default();
  command.option("--seed", options.seed, "Seed of the first scene; the same seed, the same scene")
      .type_name("S")
      .show_default();
  command.option("--objects", options.objects, "Things that stand in each scene")
      .type_name("N")
      .range(0, 1000)
      .show_default();
}

}  // namespace

void add_synth(CommandLine& line) {
  auto options = std::make_shared<SynthOptions>();
  Command command = line.add("synth", "Generate scenes with exact truth, and with faults if wanted",
                             [options] { return synth(*options); });
  command.option("output", options->folder, "Folder for scene_0001, scene_0002, ...")
      .type_name("OUTPUT_DIR")
      .required();
  add_scene_options(command, *options);
  command.option("--fault", options->faults, "What shall be wrong with the images; see below")
      .type_name("NAME[=VALUE] ...");
  command.option("--bits", options->bits, "Of the images, 8 or 16")
      .type_name("N")
      .one_of({8, 16})
      .show_default();
  command.flag("--grey", options->grey, "Images of one channel");
  command.flag("--force", options->force,
               "Write into a folder that is not empty, and replace scenes of the same names");
  add_threads_option(command, options->threads);
  add_satellite_options(command, options->satellite);
  command.footer(fault_help());
}

}  // namespace xgm::cli
