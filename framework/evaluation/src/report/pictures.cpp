// SPDX-License-Identifier: Apache-2.0
#include "report/pictures.hpp"

#include <cmath>
#include <limits>

namespace xgm::report {
namespace {

constexpr std::uint8_t kVisible = 255;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// |disparity - truth|, px; NaN where either is missing.
float error_at(const DisparityMap& map, const cv::Mat1f& truth, cv::Point p) {
  if (!map.has_disparity(p.y, p.x) || !std::isfinite(truth(p))) return kNone;
  return std::abs(map.disparity(p) - truth(p));
}

}  // namespace

cv::Mat3b in_ramp(const cv::Mat1f& values, const Ramp& ramp, const Span& span) {
  cv::Mat3b picture(values.size());
  for (int y = 0; y < values.rows; ++y) {
    for (int x = 0; x < values.cols; ++x) {
      picture(y, x) = colour_at(ramp, span, static_cast<double>(values(y, x)));
    }
  }
  return picture;
}

cv::Mat3b in_classes(const cv::Mat1b& codes, const std::vector<Class>& classes) {
  cv::Mat3b picture(codes.size());
  for (int y = 0; y < codes.rows; ++y) {
    for (int x = 0; x < codes.cols; ++x) picture(y, x) = classes.at(codes(y, x)).colour;
  }
  return picture;
}

std::vector<double> shares_of(const cv::Mat1b& codes, std::size_t classes) {
  std::vector<double> shares(classes);
  for (const uchar code : codes) ++shares.at(code);
  for (double& share : shares) share /= static_cast<double>(codes.total());
  return shares;
}

cv::Mat1f error_map(const DisparityMap& map, const cv::Mat1f& truth, const Sampling& sampling) {
  cv::Mat1f errors(sampling.shown());
  for (int y = 0; y < errors.rows; ++y) {
    for (int x = 0; x < errors.cols; ++x) errors(y, x) = error_at(map, truth, sampling.at(x, y));
  }
  return errors;
}

cv::Mat1b verdicts(const DisparityMap& map, const GroundTruth& truth, double delta) {
  cv::Mat1b codes(map.size());
  for (int y = 0; y < codes.rows; ++y) {
    for (int x = 0; x < codes.cols; ++x) {
      const bool visible = truth.non_occluded.empty() || truth.non_occluded(y, x) == kVisible;
      Verdict verdict = Verdict::not_judged;
      if (visible && std::isfinite(truth.disparity(y, x))) {
        const bool good = double{error_at(map, truth.disparity, {x, y})} <= delta;
        verdict = !map.has_disparity(y, x) ? Verdict::no_disparity
                  : good                   ? Verdict::good
                                           : Verdict::bad;
      }
      codes(y, x) = static_cast<std::uint8_t>(verdict);
    }
  }
  return codes;
}

RangeMaps range_maps(const DisparityRange& range, const Sampling& sampling) {
  const cv::Size size = sampling.shown();
  RangeMaps maps{cv::Mat1f(size, kNone), cv::Mat1f(size, kNone), cv::Mat1f(size, 0.F)};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const cv::Point p = sampling.at(x, y);
      const Interval interval = range.at(p.y, p.x);
      if (interval.empty()) continue;
      maps.first(y, x) = static_cast<float>(interval.begin);
      maps.last(y, x) = static_cast<float>(interval.end - 1);
      maps.count(y, x) = static_cast<float>(interval.size());
    }
  }
  return maps;
}

double mean_count(const DisparityRange& range) {
  const cv::Size size = range.size();
  double sum = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) sum += range.at(y, x).size();
  }
  return sum / size.area();
}

}  // namespace xgm::report
