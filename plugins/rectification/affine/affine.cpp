// SPDX-License-Identifier: Apache-2.0
// One affine map per image. Over a window of a few thousand pixels a pushbroom camera is affine to
// some hundredths of a pixel, and the epipolar lines of affine cameras are parallel: a rotation
// lays them into rows. De Franchis, Meinhardt-Llopis, Michel, Morel, Facciolo: On
// stereo-rectification of pushbroom images (ICIP 2014).
#include <algorithm>
#include <cmath>
#include <vector>

#include "xgm/geo/stage/rectification.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

/// Places of the window and heights at which both cameras are compared.
constexpr int kPlaces = 7;
constexpr int kHeights = 5;

cv::Point2d apply(const cv::Matx23d& map, cv::Point2d p) {
  return {map(0, 0) * p.x + map(0, 1) * p.y + map(0, 2),
          map(1, 0) * p.x + map(1, 1) * p.y + map(1, 2)};
}

cv::Matx23d inverse(const cv::Matx23d& map) {
  cv::Matx23d result;
  const double det = map(0, 0) * map(1, 1) - map(0, 1) * map(1, 0);
  result(0, 0) = map(1, 1) / det;
  result(0, 1) = -map(0, 1) / det;
  result(1, 0) = -map(1, 0) / det;
  result(1, 1) = map(0, 0) / det;
  result(0, 2) = -(result(0, 0) * map(0, 2) + result(0, 1) * map(1, 2));
  result(1, 2) = -(result(1, 0) * map(0, 2) + result(1, 1) * map(1, 2));
  return result;
}

/// Where one ground point is seen.
struct Match {
  cv::Point2d base, match;
  int height = 0;  ///< index of its height, 0 to kHeights - 1
};

std::vector<Match> virtual_matches(const RpcCamera& base, const RpcCamera& match,
                                   const cv::Rect& window, const HeightInterval& heights) {
  std::vector<Match> matches;
  for (int k = 0; k < kPlaces * kPlaces * kHeights; ++k) {
    const int column = k % kPlaces, row = k / kPlaces % kPlaces, level = k / kPlaces / kPlaces;
    const cv::Point2d pixel(window.x + (window.width - 1) * column / (kPlaces - 1.0),
                            window.y + (window.height - 1) * row / (kPlaces - 1.0));
    const double height = heights.min + (heights.max - heights.min) * level / (kHeights - 1.0);
    if (const auto point = base.localize(pixel, height)) {
      matches.push_back({pixel, match.project(*point), level});
    }
  }
  return matches;
}

/// a x + b y + c x' + d y' + e = 0 for corresponding points, least squares; (a, b) has length 1 and
/// points down.
struct Epipolar {
  double a, b, c, d, e;
};

Epipolar fit_epipolar(const std::vector<Match>& matches) {
  cv::Vec4d mean;
  for (const Match& m : matches) mean += cv::Vec4d(m.base.x, m.base.y, m.match.x, m.match.y);
  mean *= 1.0 / static_cast<double>(matches.size());
  cv::Matx44d moments = cv::Matx44d::zeros();
  for (const Match& m : matches) {
    const cv::Vec4d v = cv::Vec4d(m.base.x, m.base.y, m.match.x, m.match.y) - mean;
    moments += v * v.t();
  }
  cv::Vec4d values;
  cv::Matx44d vectors;
  cv::eigen(moments, values, vectors);  // rows, by falling eigenvalue
  cv::Vec4d f(vectors(3, 0), vectors(3, 1), vectors(3, 2), vectors(3, 3));
  f *= (f[1] < 0 ? -1 : 1) / std::hypot(f[0], f[1]);
  return {f[0], f[1], f[2], f[3], -f.dot(mean)};
}

class AffineGeometry final : public Rectification {
 public:
  AffineGeometry(const std::vector<Match>& matches, const cv::Rect& window) {
    const Epipolar f = fit_epipolar(matches);
    base_ = {f.b, -f.a, 0, f.a, f.b, 0};
    const cv::Vec3d across = fit_columns(matches);
    match_ = {across[0], across[1], across[2], -f.c, -f.d, -f.e};
    place(matches, window);
    to_base_ = inverse(base_);
    to_match_ = inverse(match_);
    double sum = 0;
    for (const Match& m : matches) {
      sum += std::pow(apply(base_, m.base).y - apply(match_, m.match).y, 2);
    }
    residual_ = std::sqrt(sum / static_cast<double>(matches.size()));
  }

  cv::Size size() const override { return size_; }
  cv::Point2d to_base(cv::Point2d rectified) const override { return apply(to_base_, rectified); }
  cv::Point2d to_match(cv::Point2d rectified) const override { return apply(to_match_, rectified); }
  cv::Point2d from_base(cv::Point2d pixel) const override { return apply(base_, pixel); }
  cv::Point2d from_match(cv::Point2d pixel) const override { return apply(match_, pixel); }
  double residual() const override { return residual_; }

 private:
  /// Columns of the match image such that points at the middle height have disparity 0.
  cv::Vec3d fit_columns(const std::vector<Match>& matches) const {
    cv::Matx33d normal = cv::Matx33d::zeros();
    cv::Vec3d right;
    for (const Match& m : matches) {
      if (m.height != kHeights / 2) continue;
      const cv::Vec3d row(m.match.x, m.match.y, 1);
      normal += row * row.t();
      right += row * apply(base_, m.base).x;
    }
    return normal.solve(right, cv::DECOMP_CHOLESKY);
  }

  /// Moves both images so that the window and what it may correspond to fits in.
  void place(const std::vector<Match>& matches, const cv::Rect& window) {
    double reach = 0;
    for (const Match& m : matches) {
      reach = std::max(reach, std::abs(apply(base_, m.base).x - apply(match_, m.match).x));
    }
    cv::Point2d low(INFINITY, INFINITY), high(-INFINITY, -INFINITY);
    for (const cv::Point2d corner :
         {cv::Point2d(window.tl()), cv::Point2d(window.br()) - cv::Point2d(1, 1),
          cv::Point2d(window.x, window.br().y - 1.0), cv::Point2d(window.br().x - 1.0, window.y)}) {
      const cv::Point2d p = apply(base_, corner);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    low.x = std::floor(low.x - reach);
    low.y = std::floor(low.y);
    for (cv::Matx23d* map : {&base_, &match_}) {
      (*map)(0, 2) -= low.x;
      (*map)(1, 2) -= low.y;
    }
    size_ = {static_cast<int>(std::ceil(high.x + reach - low.x)) + 1,
             static_cast<int>(std::ceil(high.y - low.y)) + 1};
  }

  cv::Matx23d base_, match_, to_base_, to_match_;
  cv::Size size_;
  double residual_ = 0;
};

class Affine final : public Rectifier {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit Affine(Parameters) {}

  std::shared_ptr<const Rectification> run(const SatelliteImage& base, const SatelliteImage& match,
                                           const cv::Rect& window, const HeightInterval& heights,
                                           const Context& context) const override {
    const auto matches = virtual_matches(base.camera, match.camera, window, heights);
    if (matches.size() < kPlaces * kPlaces * kHeights / 2) {
      throw Error(base.file + ": its camera reaches no ground of " + std::to_string(heights.min) +
                  " to " + std::to_string(heights.max) + " m in most of the window");
    }
    auto geometry = std::make_shared<const AffineGeometry>(matches, window);
    context.figure("residual_px", geometry->residual());
    return geometry;
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Affine>("affine", "One affine map per image, from both cameras.",
                       "De Franchis, Meinhardt-Llopis, Michel, Morel, Facciolo: On "
                       "stereo-rectification of pushbroom images, ICIP 2014");
}
