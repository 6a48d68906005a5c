// SPDX-License-Identifier: Apache-2.0
// Two output folders: their records, and their maps.
#include <algorithm>
#include <array>
#include <filesystem>

#include "diff/records.hpp"
#include "xgm/base/error.hpp"
#include "xgm/evaluation/run_diff.hpp"
#include "xgm/evaluation/run_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMapFile = "disparity.pfm";
constexpr const char* kConfidenceFile = "confidence.pfm";

struct Run {
  std::optional<Json> record;
  cv::Mat1f map, confidence;
};

bool has_file(const std::string& folder, const char* name) {
  std::error_code unusable;
  return fs::exists(fs::path(folder) / name, unusable);
}

/// Empty if the folder has no such file.
cv::Mat1f read_map(const std::string& folder, const char* name) {
  return has_file(folder, name) ? read_pfm((fs::path(folder) / name).string()) : cv::Mat1f();
}

Json read_record(const std::string& folder) {
  const std::string file = (fs::path(folder) / kRecordFile).string();
  const std::string text = read_file(file);
  try {
    return Json::parse(text);
  } catch (const Error& error) {
    throw Error(file + ": is no record of a run (" + error.message() + "); run again");
  }
}

Run read_run(const std::string& folder) {
  std::error_code unusable;
  if (!fs::is_directory(folder, unusable)) {
    throw Error(folder + ": is no folder; give the output folder of a run");
  }
  Run run;
  if (has_file(folder, kRecordFile)) run.record = read_record(folder);
  run.map = read_map(folder, kMapFile);
  run.confidence = read_map(folder, kConfidenceFile);
  if (!run.record && run.map.empty()) {
    throw Error(folder + ": has neither " + kRecordFile + " nor " + kMapFile +
                "; give the output folder of a run");
  }
  return run;
}

/// Whether both have the file; says so if one has it.
bool both_have(const char* file, bool first, bool second, RunDiff& diff) {
  const auto text = [](bool there) { return there ? "is there" : kNoFigure; };
  if (first != second) diff.files.push_back({file, text(first), text(second)});
  return first && second;
}

/// The same of a file that every run should have.
bool both_should_have(const char* file, bool first, bool second, RunDiff& diff) {
  if (!first && !second) diff.notes.push_back(std::string("neither run has ") + file);
  return both_have(file, first, second, diff);
}

void compare_confidences(const Run& a, const Run& b, double threshold, RunDiff& diff) {
  const bool both = both_have(kConfidenceFile, !a.confidence.empty(), !b.confidence.empty(), diff);
  if (both && threshold == 0 && a.confidence.size() == b.confidence.size()) {
    diff.confidence = compare_maps(a.confidence, b.confidence, threshold);
  }
}

std::string size_text(cv::Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height) + " px";
}

}  // namespace

cv::Mat1f read_map_of_run(const std::string& folder) { return read_map(folder, kMapFile); }

bool RunDiff::same() const {
  const std::array parts{&files, &configuration, &program, &inputs, &map_size};
  return std::ranges::all_of(parts, [](const auto* part) { return part->empty(); }) &&
         (!map || map->differing() == 0) && (!confidence || confidence->differing() == 0);
}

RunDiff compare_runs(const std::string& first, const std::string& second, double threshold) {
  const Run a = read_run(first), b = read_run(second);
  RunDiff diff;
  if (both_should_have(kRecordFile, a.record.has_value(), b.record.has_value(), diff)) {
    try {
      compare_records(*a.record, *b.record, diff);
    } catch (const Error& error) {
      throw Error(first + " or " + second + ": run.json is no record of a run (" + error.message() +
                  "); run again");
    }
  }
  if (both_should_have(kMapFile, !a.map.empty(), !b.map.empty(), diff)) {
    if (a.map.size() == b.map.size()) {
      diff.map = compare_maps(a.map, b.map, threshold);
    } else {
      diff.map_size.push_back({"size", size_text(a.map.size()), size_text(b.map.size())});
    }
  }
  compare_confidences(a, b, threshold, diff);
  return diff;
}

}  // namespace xgm
