// SPDX-License-Identifier: Apache-2.0
#include "plugins/pointing/pair_offsets/corrections.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace xgm::geo {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

PairOffset pair_offset(const std::vector<SatelliteImage>& images, const PairChoice& pair,
                       const cv::Vec2d& direction, std::vector<double> offsets, cv::Point2d here,
                       double height) {
  // What moving the base pixel does to the place where the match should be.
  const auto seen = [&](cv::Point2d pixel) {
    const auto point = images[pair.base].camera.localize(pixel, height);
    return point ? images[pair.match].camera.project(*point) : cv::Point2d();
  };
  const cv::Point2d x = seen(here + cv::Point2d(1, 0)) - seen(here);
  const cv::Point2d y = seen(here + cv::Point2d(0, 1)) - seen(here);
  return {pair, cv::Vec2d(-direction.dot({x.x, x.y}), -direction.dot({y.x, y.y})), direction,
          median(std::move(offsets))};
}

std::vector<SatelliteImage> without(const std::vector<PairOffset>& offsets,
                                    std::vector<SatelliteImage> images) {
  if (offsets.empty()) return images;
  const auto n = static_cast<Eigen::Index>(offsets.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, 2 * static_cast<Eigen::Index>(images.size()));
  Eigen::VectorXd b(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const PairOffset& e = offsets[static_cast<std::size_t>(i)];
    const auto base = 2 * static_cast<Eigen::Index>(e.pair.base);
    const auto match = 2 * static_cast<Eigen::Index>(e.pair.match);
    for (int k = 0; k < 2; ++k) {
      a(i, base + k) = e.base[k];
      a(i, match + k) = e.match[k];
    }
    b(i) = e.offset;
  }
  // Moving all cameras alike moves the ground, and no pair tells. What pairs hardly tell from that
  // is left as it is, too: noise would make it any number of pixels.
  constexpr double kTold = 0.05;  // of what is told best
  Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
  decomposition.setThreshold(kTold);
  const Eigen::VectorXd moves = decomposition.solve(b);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const auto k = 2 * static_cast<Eigen::Index>(i);
    // Points are seen where key points are: the projection moves by `moves`.
    images[i].camera = images[i].camera.cropped({-moves(k), -moves(k + 1)});
  }
  return images;
}

}  // namespace xgm::geo
