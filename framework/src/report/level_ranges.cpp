// SPDX-License-Identifier: Apache-2.0
#include "report/level_ranges.hpp"

#include <cmath>

#include "report/record_html.hpp"

namespace xgm::report {
namespace {

/// The run's disparities at a scale, rounded outwards once per halving.
std::optional<Interval> limits(const Json& record, int scale) {
  const double first = number_at(record, "/disparities/first");
  const double last = number_at(record, "/disparities/last");
  if (!std::isfinite(first) || !std::isfinite(last)) return std::nullopt;
  Interval interval{static_cast<int>(first), static_cast<int>(last) + 1};
  for (int s = scale; s > 1; s /= 2) interval = {interval.begin >> 1, (interval.end >> 1) + 1};
  return interval;
}

}  // namespace

std::optional<DisparityRange> searched(const ReportLevel& level, const Json& record) {
  const std::optional<Interval> limit = limits(record, level.scale);
  if (!level.range && !limit) return std::nullopt;
  if (!level.range) return DisparityRange::uniform(level.map.size(), *limit);
  if (!limit) return level.range;
  cv::Mat1i begin(level.map.size()), end(level.map.size());
  for (int y = 0; y < begin.rows; ++y) {
    for (int x = 0; x < begin.cols; ++x) {
      const Interval wanted = level.range->at(y, x);
      Interval kept = intersect(wanted, *limit);
      if (kept.empty() && !wanted.empty()) kept = *limit;
      begin(y, x) = kept.begin;
      end(y, x) = kept.end;
    }
  }
  return DisparityRange(begin, end);
}

}  // namespace xgm::report
