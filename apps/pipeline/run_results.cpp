// SPDX-License-Identifier: Apache-2.0
#include "run_results.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <opencv2/core.hpp>

#include "common.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm::cli {
namespace {

// Of pixels with data, about a third of a scene is hidden or hard at most; swapped images, two that
// do not belong together and a wrong range leave less than half.
constexpr double kFewMatched = 0.5;
// Within 1 px of an end of the range lie no disparities of a scene that fits into it, and a tenth
// or more of them if it does not, or if the images are swapped.
constexpr double kManyAtEnd = 0.05;
constexpr int kShortRange = 16;  // where the ends are a good part of the range

std::string in(const std::string& folder, const char* name) {
  return (std::filesystem::path(folder) / name).string();
}

std::string percent(double share) { return fmt::format("{:.2f} %", 100 * share); }

double share_of(const RunRecord& record, Status status) {
  return record.status_shares[static_cast<std::size_t>(status)];
}

/// Of the pixels with data; filled ones are guesses and tell nothing of the match.
double matched_share(const RunRecord& record) {
  return share_of(record, Status::matched) / (1 - share_of(record, Status::masked));
}

/// Of the matched pixels, the share within 1 px of `end`.
double share_at(const DisparityMap& map, int end) {
  const cv::Mat1b matched(map.status == static_cast<int>(Status::matched));
  const cv::Mat1b near((map.disparity > end - 1.0) & (map.disparity < end + 1.0) & matched);
  return cv::countNonZero(near) / std::max(1.0, static_cast<double>(cv::countNonZero(matched)));
}

void warn_of_ends(const DisparityMap& map, Interval searched) {
  if (searched.size() < kShortRange) return;
  for (const int end : {searched.begin, searched.end - 1}) {
    const double share = share_at(map, end);
    if (share < kManyAtEnd) continue;
    spdlog::warn(
        "{} of the matched disparities lie at {}, where the search range {} to {} ends: does the "
        "scene reach beyond it, or are the images swapped?",
        percent(share), end, searched.begin, searched.end - 1);
  }
}

}  // namespace

void write_results(const std::string& folder, const DisparityMap& map, const RunRecord& record) {
  std::error_code missing;  // an earlier run's record does not tell of the files written now
  std::filesystem::remove(in(folder, "run.json"), missing);
  write_pfm(in(folder, "disparity.pfm"), map.disparity);
  write_png(in(folder, "disparity.png"), disparity_picture(map));
  write_png(in(folder, "status.png"), status_picture(map));
  write_file(in(folder, "run.json"), to_json(record));  // last: it tells that all is there
}

void write_report(const std::string& folder, const RunRecord& record, const Image& left,
                  const GroundTruth& truth, ReportRun run) {
  namespace fs = std::filesystem;
  const fs::path path(record.scene);
  const std::string scene = (path.has_filename() ? path : path.parent_path()).filename().string();
  run.name = fs::path(record.pipeline_file).stem().string();
  run.record_json = to_json(record);
  Report report{scene + ", " + run.name, {}, {{scene, left, truth, {std::move(run)}}}};
  write_file(in(folder, "report.html"), report_html(report));
}

void write_explanations(const std::string& folder, const std::string& explanations) {
  write_file(in(folder, "explain.json"), explanations);
}

void print_summary(const std::string& folder, const RunRecord& record, bool has_report) {
  std::cout << "map:     " << record.size.width << " x " << record.size.height << ", "
            << percent(record.valid_share) << " of the pixels have a disparity";
  const double filled = share_of(record, Status::filled);
  if (filled > 0) {
    std::cout << " (" << percent(share_of(record, Status::matched)) << " matched, "
              << percent(filled) << " filled)";
  }
  std::cout << '\n';
  for (const auto& [region, truth] : record.truth) {
    std::cout << "truth:   " << region << ":";
    for (const ThresholdScore& score : truth.at) {
      if (score.delta == 1) std::cout << " within 1 px " << percent(1 - score.total) << ",";
    }
    std::cout << " invalid " << percent(truth.invalid)
              << fmt::format(", average error {:.3f} px", truth.average_error) << " ("
              << truth.judged << " pixels)\n";
  }
  std::cout << fmt::format("cost:    {:.2f} s of matching, {:.0f} MB at most\n",
                           record.matching_seconds,
                           static_cast<double>(record.peak_memory_bytes) / 1e6);
  std::cout << "written:";
  for (const char* name : {"disparity.png", "disparity.pfm", "status.png", "run.json"}) {
    std::cout << ' ' << in(folder, name);
  }
  if (has_report) std::cout << ' ' << in(folder, "report.html");
  std::cout << std::endl;
}

int judge(const DisparityMap& map, const RunRecord& record) {
  if (record.valid_share == 0) {
    spdlog::error(
        "the map is empty: no pixel has a disparity; see status.png for the reasons, and "
        "check the order of the images and the disparity range ({} to {})",
        record.disparities.begin, record.disparities.end - 1);
    return kFailed;
  }
  if (matched_share(record) < kFewMatched) {
    spdlog::warn(
        "only {} of the pixels were matched; see status.png for the reasons, and check that the "
        "images belong together, their order and the disparity range",
        percent(matched_share(record)));
  }
  warn_of_ends(map, record.disparities);
  return kOk;
}

}  // namespace xgm::cli
