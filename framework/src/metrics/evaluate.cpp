// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "xgm/base/error.hpp"
#include "xgm/metrics.hpp"

namespace xgm {
namespace {

constexpr std::uint8_t kJudged = 255;

void require_size(cv::Size size, cv::Size wanted, const char* what) {
  if (size == wanted) return;
  throw Error(std::string("the ") + what + " is " + std::to_string(size.width) + " x " +
              std::to_string(size.height) + " pixels but the map is " +
              std::to_string(wanted.width) + " x " + std::to_string(wanted.height) + "; give the " +
              what + " of the left image");
}

}  // namespace

Evaluation evaluate(const DisparityMap& map, const cv::Mat1f& truth, std::span<const double> deltas,
                    const cv::Mat1b& mask) {
  require_size(truth.size(), map.size(), "truth");
  if (!mask.empty()) require_size(mask.size(), map.size(), "truth mask");
  Evaluation result;
  std::int64_t invalid = 0;
  double error_sum = 0;
  std::vector<std::int64_t> bad(deltas.size());
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      if (!std::isfinite(truth(y, x)) || (!mask.empty() && mask(y, x) != kJudged)) continue;
      ++result.judged;
      if (!map.valid(y, x)) {
        ++invalid;
        continue;
      }
      const double error = std::abs(static_cast<double>(map.disparity(y, x)) - truth(y, x));
      error_sum += error;
      for (std::size_t i = 0; i < deltas.size(); ++i) bad[i] += error > deltas[i] ? 1 : 0;
    }
  }
  if (result.judged == 0) throw Error("the truth has no pixel to judge by; check file and mask");
  const auto share = [&](std::int64_t count) {
    return static_cast<double>(count) / static_cast<double>(result.judged);
  };
  const std::int64_t compared = result.judged - invalid;
  result.invalid = share(invalid);
  result.average_error = compared > 0 ? error_sum / static_cast<double>(compared)
                                      : std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < deltas.size(); ++i) {
    result.at.push_back({deltas[i], share(bad[i]), share(bad[i] + invalid)});
  }
  return result;
}

}  // namespace xgm
