// SPDX-License-Identifier: Apache-2.0
// The folders that benchmarks want uploaded, read back.
#include <doctest/doctest.h>

#include <filesystem>
#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "framework/bench/cases.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/bench_submission.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::empty_result;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Pipeline "sgm8", done on one scene; its map is given.
struct Done {
  Done(const std::string& set, const std::string& scene, const cv::Mat1f& map)
      : result(empty_result({"sgm8"}, {scene})) {
    result.request.output = folder.path();
    result.request.scenes[0].set = set;
    result.cells = {xgm::testing::done(0, 0, 0, 1.25)};
    const std::string cell = cell_folder(result.request, 0, 0);
    fs::create_directories(cell);
    write_pfm(cell + "/disparity.pfm", map);
    if (cv::countNonZero(map == map) < static_cast<int>(map.total())) result.cells[0].density = .5;
  }
  TemporaryFolder folder;
  BenchResult result;
};

std::vector<std::string> files_below(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), folder).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

const cv::Mat1f kDense = (cv::Mat1f(1, 3) << 1.5F, 2, 300);
const cv::Mat1f kSparse = (cv::Mat1f(1, 3) << 1.5F, kNone, 0);

}  // namespace

TEST_CASE("Middlebury gets dense maps as disp0METHOD.pfm") {
  Done bench("MiddEval3_trainingQ", "Teddy", kDense);
  const auto commands = write_submission(bench.result, "middlebury", "xGM");
  CHECK(files_below(bench.folder / "submit/sgm8") ==
        std::vector<std::string>{"trainingQ/Teddy/disp0xGM.pfm", "trainingQ/Teddy/timexGM.txt"});
  const cv::Mat1f map = read_pfm(bench.folder / "submit/sgm8/trainingQ/Teddy/disp0xGM.pfm");
  CHECK(cv::countNonZero(map != kDense) == 0);
  CHECK(std::stod(read_file(bench.folder / "submit/sgm8/trainingQ/Teddy/timexGM.txt")) == 1.25);
  REQUIRE(commands.size() == 1);
  CHECK(contains(commands[0], "zip"));
}

TEST_CASE("Middlebury gets maps with holes as disp0METHOD_s.pfm, holes infinite") {
  Done bench("trainingH", "Teddy", kSparse);
  write_submission(bench.result, "middlebury", "");
  const std::string file = bench.folder / "submit/sgm8/trainingH/Teddy/disp0sgm8_s.pfm";
  const std::string bytes = read_file(file);
  float hole = 0;
  std::memcpy(&hole, bytes.data() + bytes.size() - 2 * sizeof(float), sizeof hole);
  CHECK(hole == std::numeric_limits<float>::infinity());
}

TEST_CASE("ETH3D gets a map and a runtime per scene") {
  Done bench("two_view_training", "playground_1l", kSparse);
  write_submission(bench.result, "eth3d", "xGM");
  CHECK(files_below(bench.folder / "submit/sgm8") ==
        std::vector<std::string>{"low_res_two_view/playground_1l.pfm",
                                 "low_res_two_view/playground_1l.txt"});
  CHECK(read_file(bench.folder / "submit/sgm8/low_res_two_view/playground_1l.txt") ==
        "runtime 1.250\n");
}

TEST_CASE("KITTI gets 16-bit images in 1/256 px, 0 where there is no disparity") {
  Done bench("testing", "000046_10", kSparse);
  write_submission(bench.result, "kitti", "");
  CHECK(files_below(bench.folder / "submit/sgm8") ==
        std::vector<std::string>{"disp_0/000046_10.png"});
  const cv::Mat image =
      cv::imread(bench.folder / "submit/sgm8/disp_0/000046_10.png", cv::IMREAD_UNCHANGED);
  REQUIRE(image.type() == CV_16UC1);
  CHECK(image.at<std::uint16_t>(0, 0) == 384);
  CHECK(image.at<std::uint16_t>(0, 1) == 0);
  CHECK(image.at<std::uint16_t>(0, 2) == 1);  // disparity 0 is one: not to be taken for a hole
}

TEST_CASE("KITTI's images end at 65535") {
  Done bench("testing", "000046_10", kDense);
  write_submission(bench.result, "kitti", "");
  const cv::Mat image =
      cv::imread(bench.folder / "submit/sgm8/disp_0/000046_10.png", cv::IMREAD_UNCHANGED);
  CHECK(image.at<std::uint16_t>(0, 2) == 65535);
}

TEST_CASE("a frame of KITTI may be called by its left image") {
  Done bench("testing", "frame 46", kDense);
  CHECK(
      contains(error_of([&] { check_submission(bench.result.request, "kitti", ""); }), "frame 46"));
  bench.result.request.scenes[0].files.images.left = "image_2/000046_10.png";
  CHECK_NOTHROW(check_submission(bench.result.request, "kitti", ""));
}

TEST_CASE("what cannot be a submission is said before any run") {
  Done bench("my_scenes", "Teddy", kDense);
  BenchRequest& request = bench.result.request;
  CHECK(contains(error_of([&] { check_submission(request, "middlebury", ""); }), "my_scenes"));
  CHECK(contains(error_of([&] { check_submission(request, "nobody", ""); }), "choose middlebury"));
  CHECK(contains(error_of([&] { check_submission(request, "eth3d", "a/b"); }), "letters"));
  request.pipelines.push_back(request.pipelines[0]);
  CHECK(contains(error_of([&] { check_submission(request, "eth3d", "xGM"); }), "one at a time"));
}

TEST_CASE("a pipeline that failed on a scene is not submitted") {
  Done bench("trainingQ", "Teddy", kDense);
  bench.result.cells[0] = xgm::testing::failed("broken");
  CHECK(write_submission(bench.result, "middlebury", "").empty());
}
