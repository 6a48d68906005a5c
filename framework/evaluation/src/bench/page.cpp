// SPDX-License-Identifier: Apache-2.0
// The page of a bench: its tables, and the maps of all cells side by side.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "bench/judge.hpp"
#include "xgm/base/json.hpp"
#include "xgm/evaluation/bench_tables.hpp"
#include "xgm/evaluation/evaluation_json.hpp"
#include "xgm/evaluation/report.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {
namespace {

// All maps are held at once while the page is written: so many pixels of them, 5 bytes each.
constexpr double kMaxPixels = 60e6;
constexpr std::size_t kMaxBytes = 40'000'000;

/// Every step-th pixel of every step-th row, sharing nothing with `map`.
template <class Pixel>
cv::Mat_<Pixel> thinned(const cv::Mat_<Pixel>& map, int step) {
  if (map.empty()) return map;
  cv::Mat_<Pixel> few((map.rows + step - 1) / step, (map.cols + step - 1) / step);
  for (int y = 0; y < few.rows; ++y) {
    for (int x = 0; x < few.cols; ++x) few(y, x) = map(y * step, x * step);
  }
  return few;
}

Image thinned(const Image& image, int step) {
  Image few;
  for (const cv::Mat1f& plane : image.planes) few.planes.push_back(thinned(plane, step));
  few.valid = thinned(image.valid, step);
  return few;
}

DisparityMap thinned(const DisparityMap& map, int step) {
  DisparityMap few;
  few.disparity = thinned(map.disparity, step);
  few.status = thinned(map.status, step);
  return few;
}

/// The run's record with the evaluation of the tables instead of its own, which followed other
/// rules and perhaps another truth.
std::string record(const std::string& folder, const BenchCell& cell, const BenchRules& rules) {
  const std::string text = read_file((std::filesystem::path(folder) / "run.json").string());
  Json json = Json::parse(text);
  json.erase("truth");
  std::vector<RegionEvaluation> regions = cell.regions;
  if (!rules.region.empty()) {
    std::erase_if(regions, [&](const auto& region) { return region.region != rules.region; });
  }
  if (!regions.empty()) json["truth"] = to_json(regions);
  return json.dump();
}

ReportRun show(const BenchResult& result, std::size_t pipeline, std::size_t scene, int step) {
  const std::string folder = cell_folder(result.request, pipeline, scene);
  DisparityMap map = read_result(folder);
  read_statuses(folder, map);
  return {.name = result.request.pipelines[pipeline].name,
          .record_json = record(folder, result.at(pipeline, scene), result.rules),
          .map = thinned(map, step)};
}

/// What cannot be read any more is left out, and `missing` tells.
ReportScene show(const BenchResult& result, std::size_t scene, std::string& missing) {
  const BenchScene& where = result.request.scenes[scene];
  const Image left = read_pair(where.files.images).pair.base;
  const auto maps = static_cast<double>(result.cells.size());
  const int step =
      std::max(1, static_cast<int>(std::ceil(std::sqrt(left.size().area() * maps / kMaxPixels))));
  ReportScene shown{.name = where.files.name, .left = thinned(left, step), .truth = {}, .runs = {}};
  if (sets(result).size() > 1) shown.name = where.set + ", " + shown.name;
  if (step > 1) shown.name += " (1 of " + std::to_string(step * step) + " pixels)";
  const TruthFiles& truth = where.files.truth;
  if (!truth.disparity.file.empty()) {
    const GroundTruth all = load_truth(truth, left.size());
    shown.truth.disparity = thinned(all.disparity, step);
    shown.truth.non_occluded = thinned(all.non_occluded, step);
  }
  for (std::size_t i = 0; i < result.request.pipelines.size(); ++i) {
    if (result.at(i, scene).state != CellState::done) continue;
    try {
      shown.runs.push_back(show(result, i, scene, step));
    } catch (const std::exception& error) {
      missing += "<p>" +
                 html_text(result.request.pipelines[i].name + " on " + shown.name +
                           " is not shown: " + error.what()) +
                 "</p>\n";
    }
  }
  return shown;
}

}  // namespace

std::string bench_html(const BenchResult& result) {
  Report report{.title = "Bench",
                .tables_html = bench_tables_html(result),
                .scenes = {},
                .max_bytes = kMaxBytes};
  for (std::size_t scene = 0; scene < result.request.scenes.size(); ++scene) {
    if (result.any_done(scene)) {
      report.scenes.push_back(show(result, scene, report.tables_html));
    }
  }
  return report_html(report);
}

}  // namespace xgm
