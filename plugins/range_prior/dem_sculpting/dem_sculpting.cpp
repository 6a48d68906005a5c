// SPDX-License-Identifier: Apache-2.0
// The paper's section "DEM-Sculpting for Satellite Stereo Matching", steps 1 to 7: two copies of
// the DEM, moved up and down, bound the disparities of every pixel.
#include <algorithm>
#include <cmath>
#include <optional>

#include "xgm/base/parallel.hpp"
#include "xgm/geo/stage/range_prior.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

/// A DEM moved up or down.
class Moved final : public HeightField {
 public:
  Moved(const HeightField& dem, double offset) : dem_(dem), offset_(offset) {}
  std::optional<double> height(double longitude, double latitude) const override {
    const auto height = dem_.height(longitude, latitude);
    return height ? std::optional(*height + offset_) : std::nullopt;
  }
  HeightInterval bounds() const override {
    const HeightInterval bounds = dem_.bounds();
    return {bounds.min + offset_, bounds.max + offset_};
  }
  double posting() const override { return dem_.posting(); }

 private:
  const HeightField& dem_;
  double offset_;
};

class DemSculpting final : public RangePrior {
 public:
  struct Parameters {
    double upper = 0.5;
    double lower = 0.15;
    double margin = 15;
    int step = 8;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    set.add("upper", p.upper,
            "Share of what the camera's heights reach above the DEM, by which the upper surface is "
            "moved up.")
        .range(0, 1);
    set.add("lower", p.lower, "The same below the DEM, for the lower surface.").range(0, 1);
    set.add("margin", p.margin,
            "What both surfaces are moved by at least, for buildings, trees and errors of the DEM. "
            "0: the paper's formula alone.")
        .unit("m")
        .range(0, 1000);
    set.add("step", p.step,
            "Distance of the pixels that are projected; others are like the nearest.")
        .unit("px")
        .range(1, 512);
  }

  explicit DemSculpting(Parameters parameters) : p_(parameters) {}

  bool needs_dem() const override { return true; }

  HeightInterval heights(const SatelliteImage& base, const SatelliteImage&, const cv::Rect& window,
                         const HeightField* dem, const Context&) const override {
    if (dem == nullptr) throw UsageError("range_prior dem_sculpting: give a DEM (--dem FILE)");
    const HeightInterval ground = dem_heights(base, window, *dem);
    const HeightInterval moves = offsets(base.camera.heights(), dem->bounds());
    return {ground.min + moves.min, ground.max + moves.max};
  }

  DisparityRange run(const RectifiedPair& pair, const HeightField* const& dem,
                     const Context& context) const override {
    const HeightInterval moves = offsets(pair.base.camera.heights(), dem->bounds());
    context.figure("upper_m", moves.max);
    context.figure("lower_m", moves.min);
    return spread(project(pair, Moved(*dem, moves.max), Moved(*dem, moves.min)),
                  pair.geometry->size());
  }

 private:
  using SparseBounds = cv::Mat_<cv::Vec2i>;  // begin and end of each grid point's interval

  /// Step 1. Neither surface crosses the DEM, also where the camera's heights lie within it.
  HeightInterval offsets(const HeightInterval& camera, const HeightInterval& ground) const {
    return {std::min(p_.lower * (camera.min - ground.min), -p_.margin),
            std::max(p_.upper * (camera.max - ground.max), p_.margin)};
  }

  /// Steps 2 to 6.
  SparseBounds project(const RectifiedPair& pair, const HeightField& upper,
                       const HeightField& lower) const {
    const cv::Size size = pair.geometry->size();
    const auto points = [&](int length) { return (length - 1) / p_.step + 1; };
    SparseBounds bounds(points(size.height), points(size.width), cv::Vec2i(0, 0));
    parallel_for(0, bounds.rows, [&](int row) {
      for (int column = 0; column < bounds.cols; ++column) {
        const cv::Point2d pixel =
            pair.geometry->to_base(cv::Point2d(column * p_.step, row * p_.step));
        const auto high = pair.base.camera.localize(pixel, upper);
        const auto low = pair.base.camera.localize(pixel, lower);
        if (!high || !low) continue;
        const double a = pair.see(*low)[2], b = pair.see(*high)[2];
        bounds(row, column) = {static_cast<int>(std::floor(std::min(a, b))),
                               static_cast<int>(std::ceil(std::max(a, b))) + 1};
      }
    });
    return bounds;
  }

  /// Step 7: every pixel is like the nearest grid point that has bounds.
  DisparityRange spread(const SparseBounds& sparse, cv::Size size) const {
    const SparseBounds filled = fill(sparse);
    return DisparityRange::of_pixels(size, [&](int y, int x) {
      const int row = std::min((y + p_.step / 2) / p_.step, filled.rows - 1);
      const int column = std::min((x + p_.step / 2) / p_.step, filled.cols - 1);
      const cv::Vec2i bounds = filled(row, column);
      return Interval{bounds[0], bounds[1]};
    });
  }

  static bool is_empty(const cv::Vec2i& bounds) { return bounds[1] <= bounds[0]; }

  static SparseBounds fill(const SparseBounds& sparse) {
    SparseBounds filled = sparse.clone();
    for (int row = 0; row < sparse.rows; ++row) {
      for (int column = 0; column < sparse.cols; ++column) {
        if (is_empty(sparse(row, column))) filled(row, column) = nearest(sparse, row, column);
      }
    }
    return filled;
  }

  static cv::Vec2i nearest(const SparseBounds& sparse, int row, int column) {
    const int reach = std::max(sparse.rows, sparse.cols);
    int best = 2 * reach * reach + 1;
    cv::Vec2i found(0, 0);
    for (int r = 0; r < sparse.rows; ++r) {
      for (int c = 0; c < sparse.cols; ++c) {
        const int distance = (r - row) * (r - row) + (c - column) * (c - column);
        if (distance >= best || is_empty(sparse(r, c))) continue;
        best = distance;
        found = sparse(r, c);
      }
    }
    return found;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<DemSculpting>(
      "dem_sculpting",
      "A range per pixel: disparities between two copies of a DEM, moved up and down.",
      "Patil, Prakash, Comandur, Kak: A Comparative Evaluation of SGM Variants (including a New "
      "Variant, tMGM) for Dense Stereo Matching, section DEM-Sculpting");
}
