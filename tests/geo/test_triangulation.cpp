// SPDX-License-Identifier: Apache-2.0
// Points on the ground, beside those of an independent program.
#include <gdal_priv.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "support/support.hpp"
#include "xgm/geo/camera/meeting.hpp"
#include "xgm/geo/camera/read_rpc.hpp"
#include "xgm/geo/ground/raster.hpp"
#include "xgm/geo/registry.hpp"
#include "xgm/geo/stage/triangulation.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::test_data;

namespace {

/// An epipolar grid: what is added to a place in the rectified image, every `step` px.
class Grid {
 public:
  explicit Grid(const std::string& file) : x_(read_raster(file, 1)), y_(read_raster(file, 2)) {}
  cv::Point2d operator()(cv::Point2d p) const {
    return p + cv::Point2d(at(x_.values, p), at(y_.values, p));
  }

 private:
  double at(const cv::Mat1f& values, cv::Point2d p) const {
    const double u = p.x / 30, v = p.y / 30;
    const int x = std::min(static_cast<int>(u), values.cols - 2);
    const int y = std::min(static_cast<int>(v), values.rows - 2);
    const double a = u - x, b = v - y;
    return (1 - b) * ((1 - a) * double{values(y, x)} + a * double{values(y, x + 1)}) +
           b * ((1 - a) * double{values(y + 1, x)} + a * double{values(y + 1, x + 1)});
  }
  Raster x_, y_;
};

class GridGeometry final : public Rectification {
 public:
  GridGeometry(const std::string& folder, cv::Size size)
      : base_(folder + "left_epipolar_grid.tif"),
        match_(folder + "right_epipolar_grid.tif"),
        size_(size) {}
  cv::Size size() const override { return size_; }
  cv::Point2d to_base(cv::Point2d p) const override { return base_(p) - first_pixel_; }
  cv::Point2d to_match(cv::Point2d p) const override { return match_(p) - first_pixel_; }
  cv::Point2d from_base(cv::Point2d) const override { return {}; }
  cv::Point2d from_match(cv::Point2d) const override { return {}; }
  double residual() const override { return 0; }

 private:
  Grid base_, match_;
  cv::Size size_;
  cv::Point2d first_pixel_{0.5, 0.5};  // the centre of the first pixel in OTB and shareloc
};

/// Three bands of doubles.
cv::Mat3d read_points(const std::string& file) {
  GDALDataset* const dataset = GDALDataset::Open(file.c_str());
  REQUIRE(dataset != nullptr);
  cv::Mat3d points(dataset->GetRasterYSize(), dataset->GetRasterXSize());
  const auto failed = dataset->RasterIO(GF_Read, 0, 0, points.cols, points.rows, points.data,
                                        points.cols, points.rows, GDT_Float64, 3, nullptr,
                                        sizeof(cv::Vec3d), 0, sizeof(double), nullptr);
  GDALClose(dataset);
  REQUIRE(failed == CE_None);
  return points;
}

std::shared_ptr<const Triangulation> rays() {
  Registry registry;
  add_geo(registry);
  return make_stage<Triangulation>("rays", registry);
}

}  // namespace

TEST_CASE("two rays meet in the middle of their shortest line") {
  const Ray a{{0, 0, 10}, {0, 0, -1}};
  const Ray b{{4, 0.2, 0}, {-1, 0, 0}};
  const Meeting meeting = meet(a, b);
  CHECK(cv::norm(meeting.point - cv::Vec3d(0, 0.1, 0)) < 1e-12);
  CHECK(meeting.gap == doctest::Approx(0.2));
  CHECK(std::isnan(meet(a, a).gap));
}

TEST_CASE("points of a Pleiades pair lie within a millimetre of those of another program") {
  const auto data = test_data("a triangulation reference");
  if (!data) return;
  const std::string reference =
      (*data / "satellite/derived/cars_triangulation_reference/").string();
  const std::string shareloc = (*data / "satellite/shareloc/tests/data/").string();
  const cv::Mat1f disparity = cv::imread(reference + "nice_disp_f32.tif", cv::IMREAD_UNCHANGED);
  const cv::Mat3d expected = read_points(reference + "nice_xyz_ecef_f64.tif");
  REQUIRE_FALSE(disparity.empty());
  REQUIRE(expected.size() == disparity.size());

  RectifiedPair pair{
      {.name = {},
       .file = {},
       .band = 1,
       .mask = {},
       .size = {},
       .camera = RpcCamera(
           read_rpc(shareloc + "rpc/PHR1B_P_201709281038045_SEN_PRG_FC_178608-001.geom").front()),
       .acquisition = {}},
      {.name = {},
       .file = {},
       .band = 1,
       .mask = {},
       .size = {},
       .camera = RpcCamera(
           read_rpc(shareloc + "rpc/PHR1B_P_201709281038393_SEN_PRG_FC_178609-001.geom").front()),
       .acquisition = {}},
      {},
      std::make_shared<const GridGeometry>(shareloc + "rectification_grids/", disparity.size())};
  DisparityMap map(disparity.size());
  for (int y = 0; y < disparity.rows; ++y) {
    for (int x = 0; x < disparity.cols; ++x) map.set(y, x, -disparity(y, x));
  }
  const PointGrid points = rays()->run(pair, map, Context());
  double worst = 0;
  int compared = 0;
  for (int y = 0; y < disparity.rows; ++y) {
    for (int x = 0; x < disparity.cols; ++x) {
      worst = std::max(worst, cv::norm(points.ecef(y, x) - expected(y, x)));
      ++compared;
    }
  }
  MESSAGE(compared << " points, the farthest " << 1000 * worst << " mm");
  CHECK(worst <= 1e-3);
}
