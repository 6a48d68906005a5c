// SPDX-License-Identifier: Apache-2.0
#include "bench/judge.hpp"

#include <cmath>
#include <filesystem>

#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"
#include "xgm/evaluation/bench_tables.hpp"
#include "xgm/io/pfm.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {
namespace fs = std::filesystem;
namespace {

/// The figures of a record. Throws Error if one is missing, or is none of a run.
BenchCell to_cell(const Json& json) {
  BenchCell cell;
  cell.state = CellState::done;
  cell.seconds = json.at("seconds").at("matching").number();
  cell.peak_bytes = json.at("peak_memory_bytes").number();
  cell.density = json.at("valid_share").number();
  const double width = json.at("scene").at("width").number();
  const double height = json.at("scene").at("height").number();
  const double first = json.at("disparities").at("first").number();
  const double last = json.at("disparities").at("last").number();
  cell.evaluations = width * height * (last - first + 1);
  for (const double figure : {cell.seconds, cell.peak_bytes, cell.density, cell.evaluations}) {
    if (!std::isfinite(figure) || figure < 0) throw Error("one of its figures is below 0");
  }
  return cell;
}

BenchCell read_record(const std::string& folder) {
  const std::string file = (fs::path(folder) / "run.json").string();
  const std::string text = read_file(file);
  try {
    return to_cell(Json::parse(text));
  } catch (const Error& error) {
    throw Error(file + ": is no record of a run (" + error.what() + "); remove it and run again");
  }
}

}  // namespace

DisparityMap read_result(const std::string& folder) {
  DisparityMap map;
  map.disparity = read_pfm((fs::path(folder) / "disparity.pfm").string());
  map.status.create(map.disparity.size());
  for (int y = 0; y < map.status.rows; ++y) {
    for (int x = 0; x < map.status.cols; ++x) {
      const bool valid = std::isfinite(map.disparity(y, x));
      map.status(y, x) = static_cast<std::uint8_t>(valid ? Status::matched : Status::ambiguous);
    }
  }
  return map;
}

BenchCell judge_cell(const std::string& folder, const BenchScene& scene, const BenchRules& rules) {
  BenchCell cell = read_record(folder);
  if (scene.files.truth.disparity.file.empty()) return cell;
  const DisparityMap map = read_result(folder);
  EvaluationRules evaluation{.deltas = rules.thresholds,
                             .scale = rules.scale > 0 ? rules.scale : scene.files.scale};
  const auto& searched = scene.files.disparities;
  if (rules.clip && !searched) throw Error("--clip: the scene has no ndisp to clip to");
  if (rules.clip) require_disparities_of_size(scene.files, map.size());
  if (rules.clip) evaluation.clip = benchmark_clip(*searched);
  cell.regions = evaluate_regions(map, load_truth(scene.files.truth, map.size()), evaluation);
  return cell;
}

const Evaluation* judged(const BenchCell& cell, const BenchRules& rules) {
  const auto find = [&](const std::string& name) -> const Evaluation* {
    for (const auto& [region, evaluation] : cell.regions) {
      if (region == name) return &evaluation;
    }
    return nullptr;
  };
  if (!rules.region.empty()) return find(rules.region);
  const Evaluation* visible = find("non-occluded");
  return visible != nullptr ? visible : find("all");
}

}  // namespace xgm
