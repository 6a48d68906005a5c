// SPDX-License-Identifier: Apache-2.0
// A generated pair with planted holes: the record says of each empty cell why it is empty.
#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>

#include "geo/generated.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/base/json.hpp"
#include "xgm/geo/ground/dem.hpp"
#include "xgm/geo/registry.hpp"
#include "xgm/geo/run/recorded_surface.hpp"
#include "xgm/geo/stage/range_prior.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/pipeline/pipeline.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

constexpr int kSize = 400;
constexpr int kUnsearched = 60;            // columns of the base image
const cv::Rect kMasked(110, 100, 60, 60);  // on the plain

/// Searches all but the first columns of the base image.
class SearchesTheRest final : public RangePrior {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit SearchesTheRest(Parameters) {}

  HeightInterval heights(const SatelliteImage&, const SatelliteImage&, const cv::Rect&,
                         const HeightField* dem, const Context&) const override {
    return {dem->bounds().min - 20, dem->bounds().max + 30};
  }
  DisparityRange run(const RectifiedPair& pair, const KnownSurfaces& known,
                     const Context& context) const override {
    const DisparityRange all = RangePrior::run(pair, known, context);
    return DisparityRange::of_pixels(all.size(), [&](int y, int x) {
      const bool is_searched = pair.geometry->to_base(cv::Point2d(x, y)).x >= kUnsearched;
      return is_searched ? all.at(y, x) : Interval{};
    });
  }
};

/// Blocks of 25 m, 64 m wide, 56 m from each other on a plain; seen from both sides. What is
/// narrower than 60 m becomes a building, whose roof has no texture.
SatelliteSceneSpec town(const std::string& folder) {
  cv::Mat1f blocks(120, 120, 100.0F);  // the generator repeats it, mirrored
  blocks(cv::Rect(56, 56, 64, 64)).setTo(125);
  const std::string file = folder + "/blocks.tif";
  write_raster(file, {blocks, {}, {}, {}});
  SatelliteSceneSpec spec;
  spec.size = kSize;
  spec.relief_file = file;
  spec.posting = spec.relief_posting = 0.5;
  spec.cars = 0;
  spec.views = {{.azimuth = 100, .incidence = 20, .heading = 188, .pointing_error = {}},
                {.azimuth = 280, .incidence = 15, .heading = 193, .pointing_error = {}}};
  return spec;
}

constexpr const char* kPipeline = R"(xgm: 1
type: surface
pointing: none
range_prior: searches_the_rest
matching:
  type: stereo
  matcher:
    type: left_right
    consistency: {type: lrrl, threshold: 1}
    matcher:
      type: semi_global
      cost: {type: census, window: 5}
      penalty: {type: constant, p1: 24, p2: 96}
      aggregation: {type: sgm, directions: 8}
      selection: wta
      filters:
        - {type: peak_removal}
surface: mean
)";

struct Run {
  TemporaryFolder folder;
  SatelliteScene scene;
  RecordedSurface recorded;
};

Pipeline pipeline_of(const std::string& folder, const std::vector<Override>& overrides) {
  static const Registry registry = [] {
    Registry made = Registry::with_builtins();
    add_geo(made);
    made.add<SearchesTheRest>("searches_the_rest", "For this test.");
    return made;
  }();
  const std::string file = folder + "/test.yaml";  // the record names its content
  write_file(file, kPipeline);
  LoadedPipeline loaded = load_pipeline_text(kPipeline, file, registry, overrides);
  INFO(to_string(loaded.diagnostics));
  REQUIRE(loaded.pipeline);
  return std::move(*loaded.pipeline);
}

RecordedSurface run_in(const std::string& folder, const std::string& name,
                       const std::vector<Override>& overrides = {}) {
  SurfaceFiles files{};
  files.images = {folder + "/scene/image_1.tif", folder + "/scene/image_2.tif"};
  files.masks = {folder + "/mask_1.png", folder + "/mask_2.png"};
  files.dem = {folder + "/scene/dem.tif"};
  SurfaceRecordRequest request;
  request.folder = folder + "/" + name;
  return record_surface(pipeline_of(folder, overrides), files, request);
}

const Run& planted() {
  static Run run;
  if (!run.scene.views.empty()) return run;
  run.scene = make_satellite_scene(town(run.folder / ""));
  write_satellite_scene(run.folder / "scene", run.scene);
  cv::Mat3b mask(kSize, kSize, cv::Vec3b(255, 255, 255));
  write_png(run.folder / "mask_2.png", mask);
  mask(kMasked).setTo(cv::Scalar(0, 0, 0));
  write_png(run.folder / "mask_1.png", mask);
  run.recorded = run_in(run.folder / "", "run");
  return run;
}

/// Where the images show the true point of a cell; empty: not at all.
struct TrueCell {
  cv::Point2d base, match;
  bool visible_in_both = false;  ///< and so are the cells around
  bool is_hidden = false;        ///< in one of them, and so are the cells around
};

/// Calls body(reason, true cell) for each cell of the surface that has a truth.
void for_each_cell(const Run& run, const std::function<void(CellReason, const TrueCell&)>& body) {
  const SurfaceResult& result = run.recorded.result;
  const Raster& truth = run.scene.surface;
  REQUIRE(crs_name(result.grid.crs) == crs_name(horizontal(truth.crs)));
  cv::Mat1b both;
  cv::bitwise_and(run.scene.visible[0] == 255, run.scene.visible[1] == 255, both);
  cv::Mat1b visible, hidden;
  cv::erode(both, visible, cv::Mat(), {-1, -1}, 2);
  cv::erode(255 - both, hidden, cv::Mat(), {-1, -1}, 2);
  const CrsTransform to_ecef(with_heights(result.grid.crs, "ellipsoid"), "EPSG:4978");
  for (int y = 0; y < result.grid.size.height; ++y) {
    for (int x = 0; x < result.grid.size.width; ++x) {
      const cv::Point2d centre = result.grid.place.centre(x, y);
      const cv::Point2d there = truth.place.cell(centre);
      const cv::Point cell(cvRound(there.x), cvRound(there.y));
      if (!cv::Rect({}, truth.values.size()).contains(cell) || std::isnan(truth.values(cell))) {
        continue;
      }
      const cv::Vec3d point = to_ecef.forward({centre.x, centre.y, double{truth.values(cell)}});
      const auto base = run.scene.views[0].truth.project(point);
      const auto match = run.scene.views[1].truth.project(point);
      if (!base || !match) continue;
      body(static_cast<CellReason>(result.reasons(y, x)),
           {*base, *match, visible(cell) != 0, hidden(cell) != 0});
    }
  }
}

bool within(const cv::Rect2d& rect, cv::Point2d p, double margin) {
  return p.x > rect.x + margin && p.y > rect.y + margin && p.x < rect.br().x - margin &&
         p.y < rect.br().y - margin;
}

/// Share of `reason` among the cells that `chosen` accepts, of which there must be enough.
double share(CellReason reason, const std::function<bool(CellReason, const TrueCell&)>& chosen) {
  int hits = 0, all = 0;
  for_each_cell(planted(), [&](CellReason found, const TrueCell& cell) {
    if (!chosen(found, cell)) return;
    ++all;
    hits += found == reason ? 1 : 0;
  });
  CHECK(all > 300);
  return static_cast<double>(hits) / all;
}

const cv::Rect2d kImage(0, 0, kSize - 1, kSize - 1);

bool is_searched(const TrueCell& cell) {
  return within(kImage, cell.base, 12) && within(kImage, cell.match, 12) &&
         cell.base.x > kUnsearched + 12 &&
         !cv::Rect2d(kMasked - cv::Point(12, 12) + cv::Size(24, 24)).contains(cell.base);
}

}  // namespace

TEST_CASE("every cell has a height or a reason, and their shares sum to 1") {
  const SurfaceResult& result = planted().recorded.result;
  for (int y = 0; y < result.reasons.rows; ++y) {
    for (int x = 0; x < result.reasons.cols; ++x) {
      const bool has_height = !std::isnan(result.fused.heights.values(y, x));
      REQUIRE(has_height == (result.reasons(y, x) == 0));
    }
  }
  const Json record = Json::parse(read_file(planted().folder / "run/run.json"));
  double sum = 0;
  for (const auto& [name, value] : record.at("cells").at("shares").members()) {
    MESSAGE(name << " " << value.number());
    sum += value.number();
  }
  CHECK(sum == doctest::Approx(1).epsilon(1e-12));
  CHECK(record.at("cells").at("shares").at("height").number() ==
        doctest::Approx(record.at("covered_share").number()));
  const Raster written = read_raster(planted().folder / "run/reasons.tif");
  CHECK(written.metadata.at("code_1") == "not_seen");
  cv::Mat1f reasons;
  result.reasons.convertTo(reasons, CV_32F);
  CHECK(cv::countNonZero(written.values != reasons) == 0);
}

TEST_CASE("cells under a mask, outside of an image and outside of the bounds say so") {
  CHECK(share(CellReason::not_seen, [](CellReason, const TrueCell& cell) {
          return within(kMasked, cell.base, 8) && within(kImage, cell.match, 12);
        }) > 0.98);
  CHECK(share(CellReason::not_seen, [](CellReason, const TrueCell& cell) {
          return !within(kImage, cell.match, -8) || !within(kImage, cell.base, -8);
        }) > 0.98);
  // The height of a roof is not known there; it may be looked for 20 px away, on the ground.
  CHECK(share(CellReason::outside_bounds, [](CellReason, const TrueCell& cell) {
          return within({0, 0, kUnsearched - 20, kSize}, cell.base, 2) &&
                 within(kImage, cell.match, 12);
        }) > 0.94);
}

TEST_CASE("the hidden sides of blocks are occluded, not filtered") {
  const double hidden = share(CellReason::occluded, [](CellReason found, const TrueCell& cell) {
    return is_searched(cell) && cell.is_hidden && found != CellReason::height;
  });
  const double visible = share(CellReason::occluded, [](CellReason found, const TrueCell& cell) {
    return is_searched(cell) && cell.visible_in_both && found != CellReason::height;
  });
  MESSAGE("occluded: " << hidden << " of the hidden empty cells, " << visible << " of the visible");
  CHECK(hidden > 0.85);
  CHECK(hidden > 4 * visible);
  // What is searched in vain was seen, and its bounds were not empty.
  CHECK(share(CellReason::not_seen,
              [](CellReason, const TrueCell& cell) { return is_searched(cell); }) < 0.01);
  CHECK(share(CellReason::outside_bounds,
              [](CellReason, const TrueCell& cell) { return is_searched(cell); }) < 0.01);
}

TEST_CASE("the cloud of a run becomes the same surface again, and is not lost to it") {
  const TemporaryFolder& folder = planted().folder;
  SurfaceFiles files{};
  files.clouds = {folder / "run/cloud.ply"};
  SurfaceRecordRequest request;
  request.folder = folder / "again";
  record_surface(pipeline_of(folder / "", {}), files, request);
  for (const char* name : {"dsm.tif", "pairs.tif", "gap.tif", "source.tif"}) {
    CAPTURE(name);
    CHECK(read_file(folder / ("run/" + std::string(name))) ==
          read_file(folder / ("again/" + std::string(name))));
  }
  request.folder = folder / "run";
  CHECK(error_of([&] { record_surface(pipeline_of(folder / "", {}), files, request); }) != "");
  CHECK(std::filesystem::exists(folder / "run/cloud.ply"));
}

TEST_CASE("heights that were filled are made if asked for, and marked") {
  const TemporaryFolder& folder = planted().folder;
  const Override fill{"matching.postprocess", "[discontinuity_preserving_interpolation]"};
  const SurfaceResult without = run_in(folder / "", "without", {fill}).result;
  const SurfaceResult with =
      run_in(folder / "", "with", {fill, {"triangulation", "{type: rays, filled: true}"}}).result;
  const auto filled_cells = [](const SurfaceResult& result) {
    return cv::countNonZero(result.sources == static_cast<int>(HeightSource::filled));
  };
  CHECK(filled_cells(without) == 0);
  CHECK(cv::countNonZero(without.reasons == static_cast<int>(CellReason::filled)) > 300);
  CHECK(filled_cells(with) > 300);
  CHECK(cv::countNonZero(with.reasons == static_cast<int>(CellReason::filled)) == 0);
  const auto filled_points = [](const SurfaceResult& result) {
    return std::ranges::count(result.clouds.at(0).fills, 1);
  };
  CHECK(filled_points(without) == 0);
  CHECK(filled_points(with) >= filled_cells(with));
}
