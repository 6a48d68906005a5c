// SPDX-License-Identifier: Apache-2.0
// One affine map per image. Over a window of a few thousand pixels a pushbroom camera is affine to
// some hundredths of a pixel, and the epipolar lines of affine cameras are parallel: a rotation
// lays them into rows. De Franchis, Meinhardt-Llopis, Michel, Morel, Facciolo: On
// stereo-rectification of pushbroom images (ICIP 2014).
#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/rectification/virtual_matches/matches.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

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

/// a x + b y + c x' + d y' + e = 0 for corresponding points, least squares; (a, b) has length 1 and
/// points down.
struct Epipolar {
  double a, b, c, d, e;
};

Epipolar fit_epipolar(const std::vector<VirtualMatch>& matches) {
  cv::Vec4d mean;
  for (const VirtualMatch& m : matches) mean += cv::Vec4d(m.base.x, m.base.y, m.match.x, m.match.y);
  mean *= 1.0 / static_cast<double>(matches.size());
  cv::Matx44d moments = cv::Matx44d::zeros();
  for (const VirtualMatch& m : matches) {
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
  AffineGeometry(const std::vector<VirtualMatch>& matches, const cv::Rect& window) {
    const Epipolar f = fit_epipolar(matches);
    base_ = {f.b, -f.a, 0, f.a, f.b, 0};
    const cv::Vec3d across = fit_columns(matches);
    match_ = {across[0], across[1], across[2], -f.c, -f.d, -f.e};
    const cv::Rect shown = frame(*this, matches, window);
    for (cv::Matx23d* map : {&base_, &match_}) {
      (*map)(0, 2) -= shown.x;
      (*map)(1, 2) -= shown.y;
    }
    size_ = shown.size();
    to_base_ = inverse(base_);
    to_match_ = inverse(match_);
    residual_ = residual_of(*this, matches);
  }

  cv::Size size() const override { return size_; }
  cv::Point2d to_base(cv::Point2d rectified) const override { return apply(to_base_, rectified); }
  cv::Point2d to_match(cv::Point2d rectified) const override { return apply(to_match_, rectified); }
  cv::Point2d from_base(cv::Point2d pixel) const override { return apply(base_, pixel); }
  cv::Point2d from_match(cv::Point2d pixel) const override { return apply(match_, pixel); }
  double residual() const override { return residual_; }

 private:
  /// Columns of the match image such that points at the middle height have disparity 0.
  cv::Vec3d fit_columns(const std::vector<VirtualMatch>& matches) const {
    cv::Matx33d normal = cv::Matx33d::zeros();
    cv::Vec3d right;
    for (const VirtualMatch& m : matches) {
      if (m.height != kHeights / 2) continue;
      const cv::Vec3d row(m.match.x, m.match.y, 1);
      normal += row * row.t();
      right += row * apply(base_, m.base).x;
    }
    return normal.solve(right, cv::DECOMP_CHOLESKY);
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
    const auto matches = virtual_matches(base, match, window, heights);
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
