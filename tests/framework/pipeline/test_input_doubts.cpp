// SPDX-License-Identifier: Apache-2.0
// What comes with a scene and does not fit its images: refused where it is needed, else warned of.
#include <doctest/doctest.h>

#include <filesystem>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/pipeline.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::TemporaryFolder;

namespace {

const cv::Size kSize(40, 24);

const Pipeline& matcher() {
  static const LoadedPipeline loaded = load_pipeline_text(
      "disparities: [0, 5]\n"
      "matcher: {type: semi_global, cost: census, penalty: {type: constant, p1: 3, p2: 12}, "
      "aggregation: sgm}\n",
      "test.yaml", xgm::testing::builtins());
  REQUIRE(loaded.pipeline.has_value());
  return *loaded.pipeline;
}

/// A scene with a calib.txt: 40 x 24 px, 3 px deep.
struct Desk : TemporaryFolder {
  explicit Desk(const std::string& calib) {
    const ImagePair pair = xgm::testing::shifted_pair(kSize, 3, 5);
    write_png(*this / "im0.png", picture(pair.base));
    write_png(*this / "im1.png", picture(pair.match));
    write("calib.txt", calib);
  }
  SceneRequest request(std::optional<Interval> disparities = {}) const {
    return {.scene = find_scene(path(), xgm::testing::builtins()), .disparities = disparities};
  }
};

std::string error_of_run(const SceneRequest& request) {
  return xgm::testing::error_of([&] { run_scene(matcher(), request); });
}

const std::string kCameras = "cam0=[100 0 20; 0 100 12; 0 0 1]\ndoffs=1\nbaseline=50\n";

}  // namespace

TEST_CASE("a calibration of images of another size gives no range and no cameras") {
  for (const char* size : {"width=80\nheight=48\n", "width=80\n", "height=48\n"}) {
    CAPTURE(size);
    const Desk desk(kCameras + "ndisp=16\n" + size);
    const std::string error = error_of_run(desk.request());
    CHECK(contains(error, "calib.txt: is about images of "));
    CHECK(contains(error, "but these are 40 x 24"));
    CHECK(contains(error, "--disparities MIN:MAX"));
    const SceneRun run = run_scene(matcher(), desk.request(Interval{0, 8}));
    CHECK_FALSE(run.scene.calibration.has_value());
    REQUIRE(run.warnings.size() == 1);
    CHECK(contains(run.warnings[0], "the calibration is not used: "));
    const SceneRequest request = desk.request(Interval{0, 8});
    const DepthFiles depth{.cloud = {}, .depth = desk / "z.tiff"};
    CHECK_THROWS_AS(require_cameras_of_size(depth, request, kSize), Error);
    CHECK_NOTHROW(require_cameras_of_size({}, request, kSize));
  }
}

TEST_CASE("a calibration of the images' size, or that tells none, is used") {
  for (const char* size : {"width=40\nheight=24\n", ""}) {
    const Desk desk(kCameras + "ndisp=8\n" + size);
    const SceneRun run = run_scene(matcher(), desk.request());
    CHECK(run.warnings.empty());
    CHECK(run.scene.calibration.has_value());
    CHECK(run.disparities == Interval{0, 8});
    CHECK(run.disparities_from == desk / "calib.txt");
  }
}

TEST_CASE(
    "a range that the data set gives by itself is searched, whatever its calibration is about") {
  const Desk desk(kCameras + "width=80\nheight=48\n");
  SceneRequest request = desk.request();
  std::get<SceneFiles>(request.scene).disparities = Interval{0, 7};
  const SceneRun run = run_scene(matcher(), request);
  CHECK(run.disparities == Interval{0, 7});
  CHECK(run.disparities_from == "data set middlebury_v3");
}

TEST_CASE("a faulty calibration is told where it is needed, else warned of") {
  const Desk desk(kCameras + "ndisp=few\n");
  const SceneRun run = run_scene(matcher(), desk.request());  // the pipeline has a range
  CHECK(run.disparities_from == "pipeline");
  REQUIRE(run.warnings.size() == 1);
  CHECK(contains(run.warnings[0], "the calibration is not used: "));
  CHECK(contains(run.warnings[0], "calib.txt:4: ndisp is"));
  const auto no_range = load_pipeline_text("matcher: opencv_sgbm\n", "p", xgm::testing::builtins());
  const std::string error =
      xgm::testing::error_of([&] { run_scene(*no_range.pipeline, desk.request()); });
  CHECK(contains(error, "calib.txt:4: ndisp is"));
  CHECK(contains(error, "--disparities MIN:MAX"));
  const std::string depth = xgm::testing::error_of(
      [&] { check_depth_files({.cloud = desk / "a.ply", .depth = {}}, desk.request()); });
  CHECK(contains(depth, "--cloud: "));
  CHECK(contains(depth, "calib.txt:4: ndisp is"));
}

TEST_CASE("one image given twice is warned of: as one file, a link, a copy, or in memory") {
  const Desk desk("ndisp=8\n");
  const auto warnings = [&](const std::string& right) {
    SceneRequest request = desk.request();
    std::get<SceneFiles>(request.scene).images.right = desk / right;
    return run_scene(matcher(), request).warnings;
  };
  CHECK(warnings("im1.png").empty());
  std::filesystem::create_symlink(desk / "im0.png", desk / "link.png");
  std::filesystem::copy_file(desk / "im0.png", desk / "copy.png");
  for (const char* right : {"im0.png", "./im0.png", "link.png", "copy.png"}) {
    REQUIRE(warnings(right).size() == 1);
    CHECK(contains(warnings(right)[0], "the left and the right image are the same"));
  }
  const Image image = xgm::testing::random_image(kSize, 3, 3);
  CHECK(run_scene(matcher(), {.scene = Scene{.name = "twice", .pair = {image, image}}})
            .warnings.size() == 1);
}

TEST_CASE("depth and cloud may end in capitals") {
  const Desk desk(kCameras);
  for (const char* ending : {"TIFF", "Tif", "tiff"}) {
    const std::string file = desk / (std::string("z.") + ending);
    CHECK(check_depth_files({.cloud = {}, .depth = file}, desk.request()).depth == file);
  }
  CHECK(check_depth_files({.cloud = desk / "z.PLY", .depth = {}}, desk.request()).depth ==
        desk / "z_depth.tiff");
  CHECK_THROWS_AS(check_depth_files({.cloud = desk / "z.PLYX", .depth = {}}, desk.request()),
                  UsageError);
}
