// SPDX-License-Identifier: Apache-2.0
// Running scenes, from files and from memory: what is found, what is told, what is refused.
#include <doctest/doctest.h>

#include <algorithm>

#include <filesystem>

#include "support/paths.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"
#include "xgm/pipeline.hpp"
#include "xgm/pipeline/question.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::TemporaryFolder;

namespace {

constexpr int kDisparity = 3;
const cv::Size kSize(40, 24);

const std::string kMatcher =
    "matcher: {type: semi_global, cost: census, penalty: {type: constant, p1: 3, p2: 12}, "
    "aggregation: sgm}\n";

Pipeline load(const std::string& text = kMatcher) {
  const LoadedPipeline loaded = load_pipeline_text(text, "test.yaml", xgm::testing::builtins());
  REQUIRE(loaded.pipeline.has_value());
  return *loaded.pipeline;
}

Scene scene_in_memory() {
  return {.name = "noise",
          .pair = xgm::testing::shifted_pair(kSize, kDisparity, 5),
          .disparities = Interval{0, 8}};
}

/// The same scene as files.
struct Files : TemporaryFolder {
  Files() {
    const ImagePair pair = scene_in_memory().pair;
    write_png(*this / "left.png", picture(pair.base));
    write_png(*this / "right.png", picture(pair.match));
  }
  SceneFiles scene() const {
    return {.name = "files", .images = {.left = *this / "left.png", .right = *this / "right.png"}};
  }
  SceneRequest request() const { return {.scene = scene(), .disparities = Interval{0, 8}}; }
};

struct Listener : Observer {
  std::vector<std::string> told;
  void log(LogLevel level, const StagePlace& place, const std::string& text) override {
    told.push_back((level == LogLevel::warning ? "warning " : "note ") + place.path + "|" + text);
  }
};

std::string usage_error_of(const SceneRequest& request, const Pipeline& pipeline = load()) {
  try {
    run_scene(pipeline, request);
  } catch (const UsageError& error) {
    return error.message();
  } catch (const Error& error) {
    return std::string("no UsageError: ") + error.what();
  }
  return "";
}

std::string failure_of(const SceneRequest& request, const Pipeline& pipeline = load()) {
  try {
    run_scene(pipeline, request);
  } catch (const UsageError& error) {
    return std::string("UsageError: ") + error.what();
  } catch (const Error& error) {
    return error.message();
  }
  return "";
}

}  // namespace

TEST_CASE("run_scene: images in memory are matched, without an observer") {
  const SceneRun run = run_scene(load(), {.scene = scene_in_memory()});
  CHECK(run.maps.forward.disparity(12, 20) == kDisparity);
  CHECK(run.scene.name == "noise");
  CHECK(run.disparities == Interval{0, 8});
  CHECK(run.disparities_from == "noise");
  CHECK(run.warnings.empty());
  CHECK(run.matching_seconds > 0);
}

TEST_CASE("run_scene: files give the same map as the images in memory, and are identified") {
  const Files files;
  const SceneRun run = run_scene(load(), files.request());
  const SceneRun in_memory = run_scene(load(), {.scene = scene_in_memory()});
  CHECK(xgm::testing::identical(run.maps.forward, in_memory.maps.forward));
  CHECK(run.disparities_from == "caller");
  REQUIRE(run.scene.inputs.size() == 2);
  CHECK(run.scene.inputs[1].role == "right");
  CHECK(run.scene.inputs[1].identity.bytes > 0);
}

TEST_CASE(
    "run_scene: the caller's disparities go before the scene's, those before the pipeline's") {
  const Files files;
  const Pipeline pipeline = load("disparities: [1, 6]\n" + kMatcher);
  SceneFiles scene = files.scene();
  CHECK(run_scene(pipeline, {.scene = scene}).disparities_from == "pipeline");
  scene.disparities = Interval{0, 5};
  scene.dataset = "mine";
  CHECK(run_scene(pipeline, {.scene = scene}).disparities_from == "data set mine");
  scene.disparities_file = files / "calib.txt";
  CHECK(run_scene(pipeline, {.scene = scene}).disparities_from == files / "calib.txt");
  const SceneRequest request{
      .scene = scene, .disparities = Interval{2, 6}, .disparities_from = "someone"};
  const SceneRun run = run_scene(pipeline, request);
  CHECK(run.disparities_from == "someone");
  CHECK(run.disparities == Interval{2, 6});
}

TEST_CASE("run_scene: range maps of the images' size are searched") {
  const Files files;
  write_pfm(files / "min.pfm", cv::Mat1f(kSize, 2.0F));
  write_pfm(files / "max.pfm", cv::Mat1f(kSize, 4.0F));
  SceneRequest request{.scene = scene_in_memory(),
                       .range_maps = RangeMapFiles{files / "min.pfm", files / "max.pfm"}};
  const SceneRun run = run_scene(load(), request);
  CHECK(run.disparities == Interval{2, 5});
  CHECK(run.disparities_from == "range maps");
  CHECK(run.scene.inputs.size() == 2);
  CHECK(
      contains(usage_error_of(request, load("matcher: opencv_sgbm\n")), "one range for the whole"));
  write_pfm(files / "max.pfm", cv::Mat1f(24, 41, 4.0F));
  write_pfm(files / "min.pfm", cv::Mat1f(24, 41, 2.0F));
  CHECK(contains(failure_of(request), "range maps have the size of the left image"));
}

TEST_CASE(
    "run_scene: ranges in memory are searched as those of files are, and are given in one way") {
  const Files files;
  const cv::Mat1f low(kSize, 2.0F), high(kSize, 4.0F);
  write_pfm(files / "min.pfm", low);
  write_pfm(files / "max.pfm", high);
  SceneRequest request{.scene = scene_in_memory(),
                       .range_maps = RangeMapFiles{files / "min.pfm", files / "max.pfm"}};
  const SceneRun of_files = run_scene(load(), request);
  request.ranges = range_of_maps({low, "low"}, {high, "high"});
  CHECK(contains(usage_error_of(request), "as files and in memory"));
  request.range_maps.reset();
  const SceneRun run = run_scene(load(), request);
  CHECK(run.disparities == Interval{2, 5});
  CHECK(xgm::testing::identical(run.maps.forward, of_files.maps.forward));
  CHECK(
      contains(usage_error_of(request, load("matcher: opencv_sgbm\n")), "one range for the whole"));

  const Pipeline pipeline = load();
  const auto question = [&](const SceneRequest& of) {
    return question_of(pipeline, of, read_scene(of, pipeline), {}).dump();
  };
  const std::string before = question(request);
  CHECK(question(request) == before);
  cv::Mat1f higher = high.clone();
  higher(3, 5) = 3;  // the hull of all ranges stays
  request.ranges = range_of_maps({low, "low"}, {higher, "higher"});
  CHECK(question(request) != before);
}

TEST_CASE("run_scene: notes and warnings are in the result, and told with an empty path") {
  const Files files;
  SceneRequest request = files.request();
  request.disparities = Interval{0, 40};
  std::get<SceneFiles>(request.scene).truth.disparity.file = files.write("truth.pfm", "junk");
  Listener listener;
  const SceneRun run = run_scene(load(), request, {.observer = &listener});
  REQUIRE(run.scene.notes.size() == 1);
  CHECK(contains(run.scene.notes[0], "are as many as the image is wide"));
  REQUIRE(run.warnings.size() == 1);
  CHECK(contains(run.warnings[0], "the scene's truth is not used: "));
  CHECK(listener.told ==
        std::vector<std::string>{"note |" + run.scene.notes[0], "warning |" + run.warnings[0]});
  CHECK(run_scene(load(), request).warnings == run.warnings);
  request.disparities = Interval{-1000, 1000};
  const SceneRun beyond = run_scene(load(), request);
  CHECK(beyond.scene.notes.empty());
  CHECK(std::ranges::any_of(beyond.warnings, [](const std::string& text) {
    return contains(text, "-39 to 39 are searched");
  }));
}

TEST_CASE("run_scene: the truth that was asked for goes before the scene's own") {
  const Files files;
  write_pfm(files / "truth.pfm", cv::Mat1f(kSize, 3.0F));
  SceneRequest request = files.request();
  std::get<SceneFiles>(request.scene).truth.disparity.file = files.write("junk.pfm", "junk");
  request.truth = TruthFiles{.disparity = {files / "truth.pfm"}};
  const SceneRun run = run_scene(load(), request);
  CHECK(run.scene.truth.disparity(3, 4) == 3);
  CHECK(run.warnings.empty());
  request.truth = TruthFiles{.disparity = {files / "junk.pfm"}};
  CHECK(contains(failure_of(request), "junk.pfm"));
  write_pfm(files / "truth.pfm", cv::Mat1f(24, 41, 3.0F));
  request.truth = TruthFiles{.disparity = {files / "truth.pfm"}};
  CHECK(contains(failure_of(request), "truth.pfm: is 41 x 24 pixels"));
  request.truth = TruthFiles{.disparity = {files / "none.pfm"}};
  CHECK(contains(usage_error_of(request), "none.pfm: no such file"));
}

TEST_CASE("run_scene: mistakes of the caller are found before an image is opened") {
  const Files files;
  files.write("left.png", "not an image: opening it would be the error");
  const SceneFiles scene = files.scene();
  CHECK(contains(usage_error_of({.scene = scene}), "nothing says which disparities"));
  SceneRequest request = files.request();
  std::get<SceneFiles>(request.scene).images.right = "none.png";
  CHECK(contains(usage_error_of(request), "none.png: no such file"));
  std::get<SceneFiles>(request.scene).images.right.clear();
  CHECK(contains(usage_error_of(request), "no right image"));
  request = files.request();
  request.range_maps = RangeMapFiles{"min.pfm", "max.pfm"};
  CHECK(contains(usage_error_of(request), "min.pfm: no such file"));
  CHECK(contains(failure_of(files.request()), "left.png: is no image"));
}

TEST_CASE("run_scene: images in memory that are no pair are refused") {
  Scene scene = scene_in_memory();
  scene.pair.match = xgm::testing::random_image({39, 24}, 1);
  CHECK(contains(usage_error_of({.scene = scene}), "differ in size"));
  scene.pair.match = {};
  CHECK(contains(usage_error_of({.scene = scene}), "empty"));
  scene = scene_in_memory();
  scene.pair.base.planes.push_back(scene.pair.base.planes[0]);
  CHECK(contains(usage_error_of({.scene = scene}), "has 2 planes"));
  scene = scene_in_memory();
  scene.pair.match.valid = cv::Mat1b(3, 3, 255);
  CHECK(contains(usage_error_of({.scene = scene}), "mask of the right image"));
  scene = scene_in_memory();
  scene.truth.disparity = cv::Mat1f(3, 3, 1.0F);
  CHECK(contains(usage_error_of({.scene = scene}), "the truth is not of the images' size"));
  scene = scene_in_memory();
  scene.disparities = Interval{50, 60};
  CHECK(contains(failure_of({.scene = scene}), "cannot be seen in images 40 px wide"));
}

TEST_CASE("run_scene: more memory than allowed is refused before any work, with a remedy") {
  SceneRequest request{.scene = scene_in_memory(), .memory_limit = 1e6};
  CHECK(contains(usage_error_of(request), "allows 1 MB"));
  request.memory_limit = 4e9;
  CHECK(run_scene(load(), request).warnings.empty());
}

TEST_CASE("write_maps: three files, in a folder that is made; nothing if that cannot be") {
  const TemporaryFolder folder;
  const DisparityMap map = run_scene(load(), {.scene = scene_in_memory()}).maps.forward;
  write_maps(folder / "a/b", map);
  CHECK(read_pfm(folder / "a/b/disparity.pfm")(12, 20) == kDisparity);
  CHECK_NOTHROW(read_mask(folder / "a/b/disparity.png", MaskUse::usable));
  CHECK_NOTHROW(read_mask(folder / "a/b/status.png", MaskUse::usable));
  folder.write("file", "");
  CHECK_THROWS_AS(write_maps(folder / "file", map), UsageError);
  CHECK(folder.files() == 2);
}

TEST_CASE("depths and points are written where the cameras are known") {
  const TemporaryFolder folder;
  SceneRequest request{.scene = scene_in_memory()};
  CHECK(check_depth_files({}, request).empty());
  CHECK_THROWS_AS(check_depth_files({.cloud = folder / "a.ply"}, request), UsageError);
  const Calibration cameras{.focal = 100, .cx = 20, .cy = 12, .baseline = 50};
  std::get<Scene>(request.scene).calibration = cameras;
  const DepthFiles files = check_depth_files({.cloud = folder / "a.ply"}, request);
  CHECK(files.depth == folder / "a_depth.tiff");
  const SceneRun run = run_scene(load(), request);
  CHECK(write_depth_files(files, run.maps.forward, cameras, run.scene.pair.base) > 0);
  CHECK(folder.files() == 2);
}

TEST_CASE("require_pipeline: shipped by name, from a file, or all that is wrong at once") {
  const TemporaryFolder folder;
  const Registry& plugins = xgm::testing::builtins();
  const Pipeline shipped = require_pipeline("sgm8", plugins);
  CHECK(shipped.file() == pipelines_folder() + "/sgm8.yaml");
  const std::string file = folder.write("p.yaml", kMatcher);
  CHECK(require_pipeline(file, plugins, {{"disparities", "[1, 6]"}}).disparities() ==
        Interval{1, 7});
  folder.write("p.yaml", "matcher: {type: semi_global, cost: cenus, penalties: no}\n");
  std::string message;
  try {
    require_pipeline(file, plugins);
  } catch (const UsageError& error) {
    message = error.what();
  }
  CHECK(contains(message, "p.yaml:1:36: error: there is no cost called 'cenus'"));
  CHECK(contains(message, "penalties"));
  CHECK(std::count(message.begin(), message.end(), '\n') >= 1);
  CHECK_THROWS_AS(require_pipeline("sgm9", plugins), UsageError);
}

TEST_CASE("the installation is found from where the library lies") {
  CHECK(std::filesystem::path(library_file()).filename().string().starts_with("libxgm.so"));
  CHECK(shipped_pipelines() == shipped_pipelines(XGM_SOURCE_DIR "/pipelines"));
}
