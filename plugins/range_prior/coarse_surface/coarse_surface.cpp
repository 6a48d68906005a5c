// SPDX-License-Identifier: Apache-2.0
// Sculpting where there is no DEM: the fused surface of a run at a quarter of the resolution takes
// its place.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "plugins/range_prior/sculpting/sculpting.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/geo/ground/dem.hpp"
#include "xgm/geo/image/footprint.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr float kLargest = std::numeric_limits<float>::max();  // as beyond borders in OpenCV

/// The cells of a raster within a box and `around` it, as a raster of its own.
Raster part_of(const Raster& whole, const DegreeBox& box, int around) {
  const cv::Rect2d place = box_in(whole.crs, box);
  const cv::Point2d first = whole.place.cell({place.x, place.br().y});
  const cv::Point2d last = whole.place.cell({place.br().x, place.y});
  const cv::Point margin(around, around);
  const cv::Rect cells = cv::Rect(cv::Point(cvFloor(first.x), cvFloor(first.y)) - margin,
                                  cv::Point(cvCeil(last.x) + 1, cvCeil(last.y) + 1) + margin) &
                         cv::Rect({}, whole.values.size());
  Raster part{whole.values(cells).clone(), whole.place, with_heights(whole.crs, "ellipsoid"), {}};
  part.place.left += cells.x * whole.place.step_x;
  part.place.top += cells.y * whole.place.step_y;
  return part;
}

/// The highest (or lowest) of the cells around each, `reach` of them to all sides; NaN if none of
/// them has a height.
Raster extremes(const Raster& surface, int reach, bool highest) {
  const float nothing = highest ? -kLargest : kLargest;
  Raster result = surface;
  result.values = surface.values.clone();
  result.values.setTo(nothing, ~(surface.values == surface.values));  // NaN: not equal
  const cv::Mat window = cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U);
  if (highest) {
    cv::dilate(result.values, result.values, window);
  } else {
    cv::erode(result.values, result.values, window);
  }
  result.values.setTo(kNone, result.values == nothing);
  return result;
}

/// What bounds the coarser run: another prior, with more heights at both ends.
class Widened final : public RangePrior {
 public:
  Widened(Slot<RangePrior> prior, double share) : prior_(std::move(prior)), share_(share) {}

  HeightInterval heights(const SatelliteImage& base, const SatelliteImage& match,
                         const cv::Rect& window, const HeightField* dem,
                         const Context& context) const override {
    const HeightInterval whole = common_heights(base.camera, match.camera);
    const HeightInterval found = prior_->heights(base, match, window, dem, context);
    const double more = share_ * (found.max - found.min);
    return {std::max(found.min - more, std::min(found.min, whole.min)),
            std::min(found.max + more, std::max(found.max, whole.max))};
  }
  const Slot<RangePrior>* coarse_prior(const SatelliteImage& base, const SatelliteImage& match,
                                       const HeightInterval& heights,
                                       const HeightField* dem) const override {
    return prior_->coarse_prior(base, match, heights, dem);
  }
  DisparityRange run(const RectifiedPair& pair, const KnownSurfaces& known,
                     const Context& context) const override {
    return prior_->run(pair, known, context);
  }

 private:
  Slot<RangePrior> prior_;
  double share_;
};

class CoarseSurface final : public RangePrior {
 public:
  struct Parameters {
    Slot<RangePrior> first;
    double widening = 0.5;
    // No shares: what the coarse surface does not know of is no matter of the camera's heights.
    SculptingParameters sculpting{.upper = 0, .lower = 0, .margin = 25};
    int reach = 2;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    set.add("first", p.first,
            "Bounds the search of the run at a quarter of the resolution. Pixels where its surface "
            "is "
            "not known search all heights of the cameras.")
        .default_stage("keypoints");
    set.add("widening", p.widening,
            "Share of the heights that it finds, by which that run searches more at both ends, "
            "within "
            "those of the cameras: it takes little time, and cannot find what it does not search.")
        .range(0, 10);
    describe_sculpting(p.sculpting, set, "the coarse surface");
    set.add("reach", p.reach,
            "The upper surface is made of the highest of so many cells to all sides, the lower one "
            "of the lowest, for edges and single wrong cells. Holes that are no larger are closed.")
        .unit("cells")
        .range(0, 100);
  }

  explicit CoarseSurface(Parameters parameters)
      : p_(std::move(parameters)),
        coarse_(std::make_shared<Widened>(p_.first, p_.widening), "first") {}

  bool needs_dem() const override { return p_.first->needs_dem(); }

  HeightInterval heights(const SatelliteImage& base, const SatelliteImage& match,
                         const cv::Rect& window, const HeightField* dem,
                         const Context& context) const override {
    return p_.first->heights(base, match, window, dem, context);
  }

  const Slot<RangePrior>* coarse_prior(const SatelliteImage&, const SatelliteImage&,
                                       const HeightInterval&, const HeightField*) const override {
    return &coarse_;
  }

  DisparityRange run(const RectifiedPair& pair, const KnownSurfaces& known,
                     const Context& context) const override {
    if (known.coarse == nullptr) {
      throw Error(
          "range_prior coarse_surface: needs the surface of a run at a quarter of the "
          "resolution");
    }
    SparseBounds bounds = sculpted(pair, *known.coarse, context);
    fall_back(pair, bounds, context);
    return spread(bounds, pair.geometry->size(), p_.sculpting.step);
  }

 private:
  SparseBounds sculpted(const RectifiedPair& pair, const Raster& coarse,
                        const Context& context) const {
    const int step = p_.sculpting.step;
    const cv::Size size = pair.geometry->size();
    const SparseBounds nothing((size.height - 1) / step + 1, (size.width - 1) / step + 1,
                               cv::Vec2i(0, 0));
    const auto box = footprint(pair.base, window_of(pair), pair.heights);
    if (!box || coarse.values.empty()) return nothing;
    const Raster part = part_of(coarse, *box, p_.reach + 1);
    if (part.values.empty()) return nothing;
    if (cv::countNonZero(part.values == part.values) == 0) return nothing;
    const Dem lower(extremes(part, p_.reach, false), "the coarse surface");
    const Dem upper(extremes(part, p_.reach, true), "the coarse surface");
    const HeightInterval moves = sculpting_offsets(p_.sculpting, pair.base.camera.heights(),
                                                   {lower.bounds().min, upper.bounds().max});
    context.figure("upper_m", moves.max);
    context.figure("lower_m", moves.min);
    return sparse_bounds(pair, lower, upper, moves, step);
  }

  /// What of the base image the rectified one shows.
  static cv::Rect window_of(const RectifiedPair& pair) {
    const cv::Size size = pair.geometry->size();
    cv::Point2d low(INFINITY, INFINITY), high(-INFINITY, -INFINITY);
    for (int k = 0; k < 4; ++k) {
      const cv::Point2d p = pair.geometry->to_base(
          cv::Point2d(k % 2 * (size.width - 1.0), k / 2 * (size.height - 1.0)));
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return {cv::Point(cvFloor(low.x), cvFloor(low.y)),
            cv::Point(cvCeil(high.x) + 1, cvCeil(high.y) + 1)};
  }

  /// In place of step 7: in holes of a surface all heights of the cameras are searched.
  void fall_back(const RectifiedPair& pair, SparseBounds& bounds, const Context& context) const {
    const HeightInterval heights = common_heights(pair.base.camera, pair.match.camera);
    const int step = p_.sculpting.step;
    const cv::Rect2d image({}, cv::Size2d(pair.base.size));
    std::vector<cv::Vec2i> counts(static_cast<std::size_t>(bounds.rows));  // in holes, all
    parallel_for(0, bounds.rows, [&](int row) {
      for (int column = 0; column < bounds.cols; ++column) {
        const cv::Point2d pixel(column * step, row * step);
        cv::Vec2i& here = bounds(row, column);
        const bool is_hole = is_empty(here);
        if (image.contains(pair.geometry->to_base(pixel))) {
          counts[static_cast<std::size_t>(row)] += cv::Vec2i(is_hole ? 1 : 0, 1);
        }
        if (!is_hole) continue;
        if (const auto all = disparities_between(pair, pixel, heights)) {
          here = {all->begin, all->end};
        }
      }
    });
    const cv::Vec2i count = std::reduce(counts.begin(), counts.end());
    context.figure("unknown_share", count[0] / static_cast<double>(std::max(count[1], 1)));
  }

  Parameters p_;
  Slot<RangePrior> coarse_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<CoarseSurface>(
      "coarse_surface",
      "A range per pixel: as dem_sculpting, but around the surface of a run at a quarter of the "
      "resolution.");
}
