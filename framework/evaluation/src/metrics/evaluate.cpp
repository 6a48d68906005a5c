// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/errors.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {
namespace {

constexpr double kD1Pixels = 3;      // KITTI 2015: an outlier is off by more than this ...
constexpr double kD1Relative = .05;  // ... and by more than this share of the true disparity

/// What a map's judged pixels amount to.
struct Errors {
  std::int64_t invalid = 0;
  std::int64_t outliers = 0;   // KITTI's, among the pixels compared
  std::vector<double> values;  // of the pixels compared, px after scaling
};

Errors collect(const DisparityMap& map, const cv::Mat1f& truth, const EvaluationRules& rules,
               const cv::Mat1b& mask) {
  Errors errors;
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      if (!is_judged(truth, mask, y, x)) continue;
      if (!map.has_disparity(y, x)) {
        ++errors.invalid;
        continue;
      }
      const double error = error_at(map, truth, rules, y, x);
      const double truth_scaled = rules.scale * std::abs(static_cast<double>(truth(y, x)));
      errors.values.push_back(error);
      errors.outliers += error > kD1Pixels && error > kD1Relative * truth_scaled ? 1 : 0;
    }
  }
  return errors;
}

/// The smallest error that at least `share` of them do not exceed.
double quantile(const std::vector<double>& sorted, double share) {
  const auto wanted = static_cast<std::size_t>(std::ceil(share * double(sorted.size())));
  return sorted[std::max<std::size_t>(wanted, 1) - 1];
}

void describe_errors(const std::vector<double>& sorted, Evaluation& result) {
  double sum = 0, squares = 0;
  for (const double error : sorted) {
    sum += error;
    squares += error * error;
  }
  const auto count = static_cast<double>(sorted.size());
  result.average_error = sum / count;
  result.rms = std::sqrt(squares / count);
  result.a50 = quantile(sorted, .50);
  result.a90 = quantile(sorted, .90);
  result.a95 = quantile(sorted, .95);
  result.a99 = quantile(sorted, .99);
}

void describe_no_errors(Evaluation& result) {
  for (double* figure :
       {&result.average_error, &result.rms, &result.a50, &result.a90, &result.a95, &result.a99}) {
    *figure = std::numeric_limits<double>::quiet_NaN();
  }
}

double clipped(double disparity, Interval bounds) {
  if (bounds.empty()) return disparity;
  return std::clamp(disparity, static_cast<double>(bounds.begin), bounds.end - 1.0);
}

}  // namespace

void require_size(cv::Size size, cv::Size map, const char* what) {
  if (size == map) return;
  throw Error(std::string("the ") + what + " is " + std::to_string(size.width) + " x " +
              std::to_string(size.height) + " pixels but the map is " + std::to_string(map.width) +
              " x " + std::to_string(map.height) + "; give the " + what + " of the same view");
}

double error_at(const DisparityMap& map, const cv::Mat1f& truth, const EvaluationRules& rules,
                int y, int x) {
  const double found = clipped(static_cast<double>(map.disparity(y, x)), rules.clip);
  return rules.scale * std::abs(found - static_cast<double>(truth(y, x)));
}

Evaluation evaluate(const DisparityMap& map, const cv::Mat1f& truth, const EvaluationRules& rules,
                    const cv::Mat1b& mask) {
  require_size(truth.size(), map.size(), "truth");
  if (!mask.empty()) require_size(mask.size(), map.size(), "truth mask");
  require_judgeable({.disparity = truth, .non_occluded = mask});
  Errors errors = collect(map, truth, rules, mask);
  Evaluation result;
  result.judged = errors.invalid + static_cast<std::int64_t>(errors.values.size());
  const auto share = [&](std::int64_t count) {
    return static_cast<double>(count) / static_cast<double>(result.judged);
  };
  std::sort(errors.values.begin(), errors.values.end());
  errors.values.empty() ? describe_no_errors(result) : describe_errors(errors.values, result);
  result.invalid = share(errors.invalid);
  result.d1 = share(errors.outliers + errors.invalid);
  for (const double delta : rules.deltas) {
    const std::int64_t bad =
        errors.values.end() - std::upper_bound(errors.values.begin(), errors.values.end(), delta);
    result.at.push_back({delta, share(bad), result.invalid + share(bad)});
  }
  return result;
}

}  // namespace xgm
