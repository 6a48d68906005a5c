// SPDX-License-Identifier: Apache-2.0
// The point that is nearest to both lines of sight, least squares in ECEF: the middle of the
// shortest line between them, whose length is the gap.
#include <cmath>
#include <limits>

#include "xgm/base/parallel.hpp"
#include "xgm/geo/camera/meeting.hpp"
#include "xgm/geo/stage/triangulation.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

class Rays final : public Triangulation {
 public:
  struct Parameters {
    bool filled = false;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    set.add("filled", p.filled,
            "Also pixels whose disparity a filter has interpolated, which nothing was matched at.");
  }

  explicit Rays(Parameters parameters) : filled_(parameters.filled) {}

  PointGrid run(const RectifiedPair& pair, const DisparityMap& map, const Context&) const override {
    PointGrid points{cv::Mat3d(map.size(), cv::Vec3d(kNone, kNone, kNone)),
                     cv::Mat1f(map.size(), std::numeric_limits<float>::quiet_NaN()),
                     {}};
    const Rectification& geometry = *pair.geometry;
    parallel_for(0, map.size().height, [&](int y) {
      for (int x = 0; x < map.size().width; ++x) {
        const Status status = map.at(y, x);
        if (status != Status::matched && !(filled_ && status == Status::filled)) continue;
        const cv::Point2d here(x, y), there(x - double{map.disparity(y, x)}, y);
        const auto base = pair.base.camera.ray(geometry.to_base(here));
        const auto match = pair.match.camera.ray(geometry.to_match(there));
        if (!base || !match) continue;
        const Meeting meeting = meet(*base, *match);
        points.ecef(y, x) = meeting.point;
        points.gap(y, x) = static_cast<float>(meeting.gap);
      }
    });
    return points;
  }

 private:
  bool filled_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Rays>("rays", "The point nearest to both lines of sight, and their gap.");
}
