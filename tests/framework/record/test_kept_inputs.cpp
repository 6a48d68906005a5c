// SPDX-License-Identifier: Apache-2.0
// No run replaces a file that it reads, whatever the file is to it and however it is named.
#include <doctest/doctest.h>

#include <array>
#include <functional>

#include "framework/record/noise.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/recorded_run.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::TemporaryFolder;

namespace fs = std::filesystem;

namespace {

/// A run that asks for every output there is. No image of it is ever opened.
struct Run : TemporaryFolder {
  Run() {
    fs::create_directories(*this / "out/dump");
    fs::create_directories(*this / "scene");
    for (std::string* file : {&scene.images.left, &scene.images.right}) *file = place("image");
    pipeline_file = place("p.yaml");
    scene.calibration = Calibration{};
    scene.disparities = Interval{0, 8};
    record = {.folder = *this / "out",
              .dump = "*",
              .report = true,
              .explained = {.every = 8},
              .depth = {*this / "out/points.ply", *this / "out/depth.tiff"}};
  }
  std::string place(const std::string& name) const {
    return write("scene/" + name, xgm::testing::kNoisePipeline);
  }
  std::string message() const {
    const SceneRequest request{.scene = scene, .range_maps = maps, .truth = truth};
    const auto loaded = load_pipeline(pipeline_file, xgm::testing::builtins());
    REQUIRE(loaded.pipeline.has_value());
    try {
      record_scene(*loaded.pipeline, request, record);
    } catch (const UsageError& error) {
      return error.message();
    }
    return "";
  }

  SceneFiles scene{.name = "scene"};
  std::optional<RangeMapFiles> maps;
  std::optional<TruthFiles> truth;
  std::string pipeline_file;
  RecordRequest record;
};

struct Input {
  const char* what;
  std::function<void(Run&, const std::string&)> set;
};

RangeMapFiles& maps_of(Run& run) {
  if (!run.maps) run.maps = {run.place("min"), run.place("max")};
  return *run.maps;
}

TruthFiles& truth_of(Run& run) {
  if (!run.truth) run.truth = {.disparity = {run.place("true")}};
  return *run.truth;
}

using File = const std::string&;

std::vector<Input> inputs() {
  return {
      {"left image", [](Run& run, File file) { run.scene.images.left = file; }},
      {"right image", [](Run& run, File file) { run.scene.images.right = file; }},
      {"left mask", [](Run& run, File file) { run.scene.images.left_mask = file; }},
      {"right mask", [](Run& run, File file) { run.scene.images.right_mask = file; }},
      {"calibration", [](Run& run, File file) { run.scene.calibration_file = file; }},
      {"truth of the scene", [](Run& run, File file) { run.scene.truth.disparity.file = file; }},
      {"reverse truth", [](Run& run, File file) { run.scene.truth.reverse.file = file; }},
      {"truth of visible pixels", [](Run& run, File file) { run.scene.truth.visible.file = file; }},
      {"mask of the scene", [](Run& run, File file) { run.scene.truth.non_occluded = file; }},
      {"objects", [](Run& run, File file) { run.scene.truth.objects = file; }},
      {"--truth", [](Run& run, File file) { truth_of(run).disparity.file = file; }},
      {"--truth-mask", [](Run& run, File file) { truth_of(run).non_occluded = file; }},
      {"smallest disparities", [](Run& run, File file) { maps_of(run).min = file; }},
      {"largest disparities", [](Run& run, File file) { maps_of(run).max = file; }},
      {"pipeline", [](Run& run, File file) { run.pipeline_file = file; }},
      {"plugin file", [](Run& run, File file) {
         run.record.inputs = {{"plugin", file}};
       }}};
}

const std::vector<std::string> kOutputs{"disparity.pfm", "disparity.png", "status.png",
                                        "run.json",      "report.html",   "explain.json",
                                        "points.ply",    "depth.tiff",    "unfinished.json"};

/// Makes a file that is the output `name`, and returns how the input is named.
struct Way {
  const char* what;
  std::function<std::string(Run&, const std::string& name)> make;
};

std::string at_output(const Run& run, const std::string& name) {
  return run.write("out/" + name, xgm::testing::kNoisePipeline);
}

std::vector<Way> ways() {
  return {{"same path", at_output},
          {"relative path",
           [](Run& run, File name) { return fs::relative(at_output(run, name)).string(); }},
          {"path with ..",
           [](Run& run, File name) {
             at_output(run, name);
             return run / ("scene/../out/./" + name);
           }},
          {"link to the output",
           [](Run& run, File name) {
             fs::create_symlink(at_output(run, name), run / "link");
             return run / "link";
           }},
          {"link at the output",
           [](Run& run, File name) {
             fs::create_symlink(run.place("input"), run / ("out/" + name));
             return run / "scene/input";
           }},
          {"link to the folder",
           [](Run& run, File name) {
             at_output(run, name);
             fs::create_directory_symlink("out", run / "folder");
             return run / ("folder/" + name);
           }},
          {"hard link", [](Run& run, File name) {
             fs::create_hard_link(at_output(run, name), run / "link");
             return run / "link";
           }}};
}

void check_kept(const Input& input, const std::string& output, const Way& way) {
  CAPTURE(input.what);
  CAPTURE(output);
  CAPTURE(way.what);
  Run run;
  const std::string file = way.make(run, output);
  input.set(run, file);
  const std::string message = run.message();
  CHECK(contains(message, "out/" + output + " is an input, which would be lost"));
  CHECK(contains(message, file));
  CHECK(read_file(file) == xgm::testing::kNoisePipeline);
}

}  // namespace

TEST_CASE("record_scene: no output replaces an input, whatever both are and however named") {
  for (const Input& input : inputs()) {
    for (const std::string& output : kOutputs) {
      for (const Way& way : ways()) check_kept(input, output, way);
    }
  }
}

TEST_CASE("record_scene: what an earlier run dumped and this one reads is not removed") {
  const TemporaryFolder folder;
  const Pipeline pipeline = xgm::testing::noise_pipeline();
  SceneRequest request = xgm::testing::noise(9);
  record_scene(pipeline, request, {.folder = folder.path(), .dump = "*"});
  const std::string map = folder / "dump/matcher.forward.disparity.pfm";
  const std::string bytes = read_file(map);
  request.range_maps = {map, map};
  const RecordRequest again{.folder = folder.path()};
  CHECK(contains(xgm::testing::error_of([&] { record_scene(pipeline, request, again); }),
                 "which would be lost (smallest disparities: " + map));
  CHECK(read_file(map) == bytes);
}

TEST_CASE("record_scene: no two outputs are one file, and none is a folder or a device") {
  Run run;
  run.record.depth = {run / "out/a.ply", run / "out/a.ply"};
  CHECK(contains(run.message(), "the name must end in .tiff"));
  fs::create_symlink("disparity.pfm", run / "out/a.ply");
  run.write("out/disparity.pfm", "earlier");
  run.record.depth = {run / "out/a.ply", run / "out/b.tiff"};
  CHECK(contains(run.message(), "is written for --cloud ("));
  fs::remove(run / "out/disparity.pfm");
  fs::remove(run / "out/a.ply");
  run.record.depth = {run / "out/points.ply", run / "out/depth.tiff"};
  for (const std::string& name : kOutputs) {
    CAPTURE(name);
    fs::create_directory(run / ("out/" + name));
    CHECK(contains(run.message(), "out/" + name + " cannot be written: it is a folder"));
    fs::remove(run / ("out/" + name));
  }
  fs::create_symlink("/dev/null", run / "out/status.png");
  CHECK(contains(run.message(), "status.png cannot be written: it is a device"));
}
