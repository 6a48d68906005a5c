// SPDX-License-Identifier: Apache-2.0
// A truth that does not belong to the map, and ranges that miss the scene: what is told of them.
#include <doctest/doctest.h>

#include <limits>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/recorded_run.hpp"
#include "xgm/evaluation/truth_doubts.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::TemporaryFolder;

namespace {

const cv::Size kSize(160, 48);

/// One disparity everywhere.
DisparityMap flat(float disparity) {
  DisparityMap map(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) map.set(y, x, disparity);
  }
  return map;
}

cv::Mat1f truth_of(float disparity) { return cv::Mat1f(kSize, disparity); }

/// The only doubt, or "" if there is none.
std::string doubt(const DisparityMap& map, const cv::Mat1f& truth, Interval searched) {
  const auto found = truth_doubts(map, truth, searched);
  CHECK(found.size() <= 1);
  return found.empty() ? "" : found.front();
}

std::vector<std::string> warnings_of_run(int disparity, Interval searched, float truth) {
  const LoadedPipeline loaded = load_pipeline_text(
      "matcher: {type: left_right, consistency: lrrl, matcher: {type: semi_global, cost: census, "
      "penalty: {type: constant, p1: 3, p2: 12}, aggregation: sgm}}\n",
      "shift.yaml", xgm::testing::builtins());
  REQUIRE(loaded.pipeline.has_value());
  const TemporaryFolder folder;
  Scene scene{.name = "noise",
              .pair = xgm::testing::shifted_pair(kSize, disparity, 5),
              .disparities = searched};
  scene.truth.disparity = truth_of(truth);
  return record_scene(*loaded.pipeline, {.scene = scene}, {.folder = folder.path()})
      .record.warnings;
}

bool tells(const std::vector<std::string>& warnings, const std::string& what) {
  for (const std::string& warning : warnings) {
    if (contains(warning, what)) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("truth_doubts: a truth that was searched is not doubted, be the map right or wrong") {
  for (const float disparity : {9.0F, 20.0F, 0.0F}) {
    CHECK(doubt(flat(disparity), truth_of(9), {0, 32}) == "");
  }
  CHECK(doubt(flat(31.4F), truth_of(31.6F), {0, 32}) == "");
  CHECK(doubt(flat(-9), truth_of(-9), {-32, 1}) == "");
  CHECK(doubt(flat(9), truth_of(9), {}) == "");
  CHECK(doubt(flat(9), truth_of(std::numeric_limits<float>::quiet_NaN()), {0, 32}) == "");
}

TEST_CASE("truth_doubts: truth outside of the range is told with its share and extent") {
  cv::Mat1f truth = truth_of(9);
  truth.rowRange(0, 12).setTo(40);
  const std::string told = doubt(flat(9), truth, {0, 32});
  CHECK(contains(
      told,
      "25.00 % of the true disparities (9.0 to 40.0) lie outside of the search range 0 to 31"));
  truth = truth_of(9);
  truth(0, 0) = 40;  // a few wrong pixels are the truth's own
  CHECK(doubt(flat(9), truth, {0, 32}) == "");
}

TEST_CASE("truth_doubts: a truth of the other sign is named") {
  const std::string message = "have the other sign: pixel x of the left image lies at x - d";
  CHECK(contains(doubt(flat(9), truth_of(-9), {0, 32}), message));
  CHECK(contains(doubt(flat(3), truth_of(-9), {0, 32}), message));  // a wrong map of this range
  CHECK(contains(doubt(flat(9.5F), truth_of(-9), {-32, 33}), message));  // both signs searched
  CHECK(contains(doubt(flat(9), truth_of(-9), {}), message));
  CHECK(doubt(flat(0.3F), truth_of(-0.3F), {-8, 9}) == "");  // zero has no sign
}

TEST_CASE("a run tells of a range that misses the scene, be it short or long") {
  const auto missed = warnings_of_run(30, {0, 8}, 30);
  CHECK(tells(missed, "where the search range 0 to 7 ends"));
  CHECK(tells(missed, "100.00 % of the true disparities (30.0 to 30.0) lie outside of the search"));
  const auto right = warnings_of_run(3, {0, 8}, 3);
  CHECK_FALSE(tells(right, "search range"));
  CHECK_FALSE(tells(right, "true disparities"));
  CHECK(tells(warnings_of_run(3, {0, 8}, -3), "have the other sign"));
}

TEST_CASE("a range that consists of its ends says nothing of them") {
  CHECK_FALSE(tells(warnings_of_run(1, {1, 2}, 1), "where the search range"));
  CHECK_FALSE(tells(warnings_of_run(1, {0, 2}, 1), "where the search range"));
}
