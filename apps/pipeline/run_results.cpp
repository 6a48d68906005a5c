// SPDX-License-Identifier: Apache-2.0
#include "run_results.hpp"

#include <spdlog/spdlog.h>

#include <filesystem>
#include <iostream>

#include "common.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm::cli {
namespace {

constexpr double kFewDisparities = 0.05;

std::string in(const std::string& folder, const char* name) {
  return (std::filesystem::path(folder) / name).string();
}

std::string percent(double share) { return fmt::format("{:.2f} %", 100 * share); }

}  // namespace

void write_results(const std::string& folder, const DisparityMap& map, const RunRecord& record) {
  write_pfm(in(folder, "disparity.pfm"), map.disparity);
  write_png(in(folder, "disparity.png"), disparity_picture(map));
  write_png(in(folder, "status.png"), status_picture(map));
  write_file(in(folder, "run.json"), to_json(record));  // last: it tells that all is there
}

void print_summary(const std::string& folder, const RunRecord& record) {
  std::cout << "map:     " << record.size.width << " x " << record.size.height << ", "
            << percent(record.valid_share) << " of the pixels have a disparity\n";
  if (record.truth) {
    const Evaluation& truth = *record.truth;
    std::cout << "truth:  ";
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
  std::cout << std::endl;
}

int judge(const RunRecord& record) {
  if (record.valid_share == 0) {
    spdlog::error(
        "the map is empty: no pixel has a disparity; see status.png for the reasons, and "
        "check the order of the images and the disparity range ({} to {})",
        record.disparities.begin, record.disparities.end - 1);
    return kFailed;
  }
  if (record.valid_share < kFewDisparities) {
    spdlog::warn(
        "the map is nearly empty: only {} of the pixels have a disparity; see status.png "
        "for the reasons, and check the order of the images and the disparity range",
        percent(record.valid_share));
  }
  return kOk;
}

}  // namespace xgm::cli
