// SPDX-License-Identifier: Apache-2.0
// Each camera is moved by the mean of what surveyed points are seen beside their projections: a
// shift per image. Fraser, Hanley: Bias compensation in rational functions for Ikonos satellite
// imagery (PE&RS 69(1), 2003), the bias parameters A0 and B0.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "xgm/geo/image/control_points.hpp"
#include "xgm/geo/stage/pointing.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

std::string stem(const std::string& file) { return std::filesystem::path(file).stem().string(); }

/// A point and what it is seen beside its projection, px.
struct Offset {
  std::string point;
  cv::Point2d offset;
};

std::vector<Offset> offsets_of(const SatelliteImage& image, const std::vector<ControlPoint>& points,
                               const Context& context) {
  std::vector<Offset> offsets;
  for (const ControlPoint& point : points) {
    if (stem(point.image) != stem(image.file)) continue;
    if (!image.camera.covers(point.ground, 0.5)) {
      context.warn(image.name + ": point " + point.name +
                   " lies beyond what the camera was made for, and is not used");
      continue;
    }
    offsets.push_back({point.name, point.pixel - image.camera.project(point.ground)});
  }
  return offsets;
}

class GroundControl final : public Pointing {
 public:
  struct Parameters {
    std::string points;
    double max_deviation = 3;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    set.add("points", p.points,
            "File of surveyed points: GeoJSON (points with the properties ji and filename), or CSV "
            "(image, column, row, longitude, latitude, height above the ellipsoid).");
    set.add("max_deviation", p.max_deviation,
            "Points farther than this from the mean of their image are named in a warning.")
        .unit("px")
        .range(0, 1000);
    set.rule({"points"}, "must name a file of surveyed points", [&p] { return !p.points.empty(); });
  }

  explicit GroundControl(Parameters parameters) : p_(std::move(parameters)) {}

  std::vector<SatelliteImage> run(const std::vector<SatelliteImage>& images,
                                  const std::vector<PairChoice>&, const GroundKnowledge&,
                                  const Context& context) const override {
    const std::vector<ControlPoint> points = read_control_points(p_.points);
    std::vector<SatelliteImage> corrected = images;
    bool any = false;
    for (SatelliteImage& image : corrected) {
      const std::vector<Offset> offsets = offsets_of(image, points, context);
      context.figure(image.name + " points", static_cast<double>(offsets.size()));
      if (offsets.empty()) {
        context.warn(image.name + ": no control point lies in it; its camera is used as it is");
        continue;
      }
      any = true;
      const cv::Point2d mean = report(image, offsets, context);
      image.camera = image.camera.cropped(-mean);  // the projection moves by `mean`
    }
    if (!any) {
      throw Error(p_.points + ": none of its points is of one of the images; it names " +
                  (points.empty() ? "none" : points.front().image) + ", the first image is " +
                  images.front().file);
    }
    return corrected;
  }

 private:
  /// The mean of the offsets.
  cv::Point2d report(const SatelliteImage& image, const std::vector<Offset>& offsets,
                     const Context& context) const {
    const double n = static_cast<double>(offsets.size());
    cv::Point2d mean, squares;
    for (const Offset& o : offsets) mean += o.offset / n;
    for (const Offset& o : offsets) {
      const cv::Point2d d = o.offset - mean;
      squares += cv::Point2d(d.x * d.x, d.y * d.y) / n;
      if (cv::norm(d) > p_.max_deviation) {
        context.warn(image.name + ": point " + o.point + " lies " + std::to_string(cv::norm(d)) +
                     " px from the mean of the points; is it the right one?");
      }
    }
    context.figure(image.name + " column_px", mean.x);
    context.figure(image.name + " row_px", mean.y);
    context.figure(image.name + " column_deviation_px", std::sqrt(squares.x));
    context.figure(image.name + " row_deviation_px", std::sqrt(squares.y));
    return mean;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<GroundControl>("ground_control",
                              "Moves each camera by the mean offset of surveyed points.",
                              "Fraser, Hanley: Bias compensation in rational functions for Ikonos "
                              "satellite imagery, PE&RS 69(1), 2003");
}
