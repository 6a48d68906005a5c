// SPDX-License-Identifier: Apache-2.0
// Scene folders are complete, and say what the scene is.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/scene.hpp"
#include "xgm/synthesis/generate.hpp"

using namespace xgm;
using namespace xgm::synthesis;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

Options tiny() {
  Options options;
  options.size = {40, 30};
  options.disparities = {0, 12};
  return options;
}

double farthest(const cv::Mat1f& a, const cv::Mat1f& b) { return cv::norm(a, b, cv::NORM_INF); }

}  // namespace

TEST_CASE("write_scene: what is read back is the scene") {
  const TemporaryFolder folder;
  for (const int bits : {8, 16}) {
    for (const bool colour : {true, false}) {
      Options options = tiny();
      options.bits = bits;
      options.colour = colour;
      const GeneratedScene scene = generate(options);
      write_scene(folder / "scene/", scene, options);
      CHECK(folder.files() == 1);  // nothing is left of the work
      const SceneFiles files = find_scene(folder / "scene", xgm::testing::builtins());
      CHECK(files.disparities == Interval{0, 12});
      const ImagePair pair = load_scene(files).pair;
      REQUIRE(pair.base.planes.size() == scene.pair.base.planes.size());
      for (std::size_t c = 0; c < pair.base.planes.size(); ++c) {
        CHECK(farthest(pair.base.planes[c], scene.pair.base.planes[c]) < 1e-4);
        CHECK(farthest(pair.match.planes[c], scene.pair.match.planes[c]) < 1e-4);
      }
      CHECK(farthest(read_disparities(folder / "scene/disp0GT.pfm").value, scene.truth) == 0);
      CHECK(farthest(read_disparities(folder / "scene/disp1GT.pfm").value,
                     cv::Mat1f(-scene.reverse_truth)) == 0);
      const cv::Mat1b mask = read_mask(folder / "scene/mask1nocc.png", MaskUse::judged).value;
      CHECK(cv::countNonZero((mask == 255) != scene.reverse_non_occluded) == 0);
      CHECK(cv::countNonZero(mask == 128) + cv::countNonZero(mask == 255) == 40 * 30);
    }
  }
}

TEST_CASE("write_scene: calib.txt is Middlebury's, and has no ndisp if it would lie") {
  const TemporaryFolder folder;
  Options options = tiny();
  const GeneratedScene scene = generate(options);
  write_scene(folder / "s", scene, options);
  const std::string text = read_file(folder / "s/calib.txt");
  CHECK(text ==
        "cam0=[36 0 19.5; 0 36 14.5; 0 0 1]\ncam1=[36 0 22.25; 0 36 14.5; 0 0 1]\ndoffs=2.75\n"
        "baseline=160\nwidth=40\nheight=30\nndisp=12\nisint=0\nvmin=0\nvmax=11\n");
  options.disparities = {-6, 6};
  write_scene(folder / "s", generate(options), options);
  CHECK_FALSE(contains(read_file(folder / "s/calib.txt"), "ndisp"));
  CHECK(contains(read_file(folder / "s/calib.txt"), "vmin=-6\nvmax=5\n"));
  CHECK_FALSE(find_scene(folder / "s", xgm::testing::builtins()).disparities.has_value());
}

TEST_CASE("write_scene: scene.json has the seed, the options and all faults") {
  const TemporaryFolder folder;
  Options options = tiny();
  options.seed = 77;
  plant(options.faults, "vertical=0,0.02,1");
  write_scene(folder / "s", generate(options), options);
  const auto record = nlohmann::json::parse(read_file(folder / "s/scene.json"));
  CHECK(record["seed"] == 77);
  CHECK(record["disparities"] == nlohmann::json{0, 11});
  CHECK(record["faults"]["vertical"]["b"] == 0.02);
  CHECK(record["faults"]["exposure"]["factor"] == 1);
  CHECK(record["faults"].size() == fault_kinds().size());
}

TEST_CASE("write_scene: what is no generated scene is not replaced") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "holiday");
  folder.write("holiday/photo.png", "photo");
  folder.write("file", "text");
  const Options options = tiny();
  const GeneratedScene scene = generate(options);
  for (const char* name : {"holiday", "file"}) {
    CHECK(contains(error_of([&] { write_scene(folder / name, scene, options); }),
                   "is there and is no generated scene"));
  }
  CHECK(read_file(folder / "holiday/photo.png") == "photo");
  CHECK(contains(error_of([&] { write_scene("/proc/scene", scene, options); }), "/proc/scene: "));
  CHECK(folder.files() == 2);
}
