// SPDX-License-Identifier: Apache-2.0
#include "run/summary.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>

#include "xgm/io/write_maps.hpp"

namespace xgm::cli {
namespace {

std::string percent(double share) { return fmt::format("{:.2f} %", 100 * share); }

double share_of(const RunRecord& record, Status status) {
  return record.status_shares[static_cast<std::size_t>(status)];
}

void print_map(const RunRecord& record) {
  std::cout << "map:     " << record.size.width << " x " << record.size.height << ", "
            << percent(record.valid_share) << " of the pixels have a disparity";
  const double filled = share_of(record, Status::filled);
  if (filled > 0) {
    std::cout << " (" << percent(share_of(record, Status::matched)) << " matched, "
              << percent(filled) << " filled)";
  }
  std::cout << '\n';
}

void print_truth(const RunRecord& record) {
  for (const auto& [region, truth] : record.truth) {
    std::cout << "truth:   " << region << ":";
    for (const ThresholdScore& score : truth.at) {
      if (score.delta == 1) std::cout << " within 1 px " << percent(1 - score.total) << ",";
    }
    std::cout << " invalid " << percent(truth.invalid)
              << fmt::format(", average error {:.3f} px", truth.average_error) << " ("
              << truth.judged << " pixels)\n";
  }
}

void print_files(const RecordedRun& result, const RecordRequest& request) {
  std::cout << "written:";
  const auto& outputs = result.record.outputs;
  const bool is_sure = std::any_of(outputs.begin(), outputs.end(),
                                   [](const auto& file) { return file.file == kConfidenceFile; });
  for (const std::string name : {"disparity.png", "disparity.pfm", "status.png", kConfidenceFile,
                                 "run.json", "report.html"}) {
    if (name == "report.html" && !request.report) continue;
    if (name == kConfidenceFile && !is_sure) continue;
    std::cout << ' ' << (std::filesystem::path(request.folder) / name).string();
  }
  std::cout << '\n';
  const DepthFiles& depth = result.depth;
  if (!depth.depth.empty()) std::cout << "depth:   " << depth.depth << " (mm)\n";
  if (depth.cloud.empty()) return;
  std::cout << "cloud:   " << depth.cloud << ", " << result.points << " points (mm)\n";
}

}  // namespace

std::string reused_line(const std::vector<std::string>& results, const std::string& folder) {
  if (results.empty()) return {};
  return fmt::format("reused:  {} result{} of {}\n", results.size(), results.size() == 1 ? "" : "s",
                     folder);
}

void print_summary(const RecordedRun& result, const RecordRequest& request) {
  const RunRecord& record = result.record;
  print_map(record);
  print_truth(record);
  std::cout << reused_line(record.reused, record.reused_from);
  std::cout << fmt::format("cost:    {:.2f} s of matching, {:.0f} MB at most\n",
                           record.matching_seconds,
                           static_cast<double>(record.peak_memory_bytes) / 1e6);
  print_files(result, request);
  std::cout << std::flush;
}

}  // namespace xgm::cli
