// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/metrics.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A row of 20 pixels, disparity 0 up to pixel 9 and 5 from pixel 10 on.
cv::Mat1f step() {
  cv::Mat1f truth(1, 20, 0.0f);
  truth.colRange(10, 20) = 5;
  return truth;
}

/// Pixels of a region that have a truth; 0 if there is no such region.
std::int64_t pixels(const GroundTruth& truth, const std::string& region) {
  DisparityMap map(truth.disparity.size());
  for (const auto& [name, evaluation] : evaluate_regions(map, truth, {})) {
    if (name == region) return evaluation.judged;
  }
  return 0;
}

/// Section 5.1 of Scharstein and Szeliski, pixel by pixel.
bool is_near_jump(const cv::Mat1f& truth, int y, int x) {
  for (int v = std::max(0, y - 4); v <= std::min(truth.rows - 1, y + 4); ++v) {
    for (int u = std::max(0, x - 4); u <= std::min(truth.cols - 1, x + 4); ++u) {
      for (const auto& [dy, dx] : {std::pair{0, 1}, {0, -1}, {1, 0}, {-1, 0}}) {
        const int w = v + dy, q = u + dx;
        if (w < 0 || w >= truth.rows || q < 0 || q >= truth.cols) continue;
        if (std::fabs(truth(v, u) - truth(w, q)) > 2) return true;
      }
    }
  }
  return false;
}

}  // namespace

// The jump is between pixels 9 and 10; a window of 9 makes that 5 to 14. Of these 7 and 8 are
// occluded (128), and of 12 nothing is known (0).
TEST_CASE("regions: by hand, with a mask of three values") {
  cv::Mat1b mask(1, 20, 255);
  mask(7) = mask(8) = 128;
  mask(12) = 0;
  const GroundTruth truth{.disparity = step(), .non_occluded = mask};
  CHECK(pixels(truth, "all") == 20);
  CHECK(pixels(truth, "non-occluded") == 17);
  CHECK(pixels(truth, "occluded") == 2);
  CHECK(pixels(truth, "near discontinuities") == 7);
}

TEST_CASE("regions: in a mask without 128, whatever is not 255 is occluded") {
  cv::Mat1b mask(1, 20, 255);
  mask(7) = mask(8) = mask(12) = 0;
  const GroundTruth truth{.disparity = step(), .non_occluded = mask};
  CHECK(pixels(truth, "occluded") == 3);
  CHECK(pixels(truth, "near discontinuities") == 7);
}

TEST_CASE("regions: KITTI's background and foreground by the object map, D1 of each") {
  cv::Mat1b objects(1, 20, uchar{0});
  objects(3) = 1;
  objects(4) = 7;
  const GroundTruth truth{.disparity = step(), .objects = objects};
  DisparityMap map({20, 1});
  for (int x = 0; x < 20; ++x) map.set(0, x, x == 3 ? 9 : truth.disparity(x));
  const auto regions = evaluate_regions(map, truth, {});
  REQUIRE(regions.size() == 3);
  CHECK(regions[0].evaluation.d1 == 1.0 / 20);
  CHECK(regions[1].region == "background");
  CHECK(regions[1].evaluation.judged == 18);
  CHECK(regions[1].evaluation.d1 == 0);
  CHECK(regions[2].region == "foreground");
  CHECK(regions[2].evaluation.d1 == 1.0 / 2);
}

TEST_CASE("regions: a jump of 2 px is none, nor is the edge of what is known") {
  cv::Mat1f truth(1, 20, 0.0f);
  truth.colRange(10, 20) = 2;
  const cv::Mat1b mask(1, 20, 255);
  CHECK(pixels({.disparity = truth, .non_occluded = mask}, "near discontinuities") == 0);
  for (const float unknown : {kNan, std::numeric_limits<float>::infinity()}) {
    truth.colRange(10, 20) = unknown;
    CHECK(pixels({.disparity = truth, .non_occluded = mask}, "near discontinuities") == 0);
    CHECK(pixels({.disparity = truth, .non_occluded = mask}, "all") == 10);
  }
}

TEST_CASE("regions: near discontinuities equals the definition on random truth") {
  xgm::testing::Random random(3);
  for (const cv::Size size : {cv::Size(1, 1), {1, 9}, {31, 17}}) {
    cv::Mat1f truth(size);
    for (float& d : truth) {
      d = random.integer(0, 9) ? static_cast<float>(random.integer(0, 40) == 0 ? 3 : 0) : kNan;
    }
    const GroundTruth known{.disparity = truth, .non_occluded = cv::Mat1b(size, 255)};
    std::int64_t expected = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        if (!std::isnan(truth(y, x)) && is_near_jump(truth, y, x)) ++expected;
      }
    }
    if (expected == 0) continue;  // 1 x 1
    CHECK(pixels(known, "near discontinuities") == expected);
  }
}

TEST_CASE("regions: without masks there is one; maps of another size are named") {
  CHECK(regions_of({.disparity = step()}).size() == 1);
  const cv::Mat1b other(2, 20, 255);
  CHECK(contains(error_of([&] { regions_of({.disparity = step(), .non_occluded = other}); }),
                 "non-occluded pixels is 20 x 2"));
  CHECK(contains(error_of([&] { regions_of({.disparity = step(), .objects = other}); }),
                 "object map is 20 x 2"));
}
