// SPDX-License-Identifier: Apache-2.0
// Two maps compared pixel by pixel, against counts made plainly.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/run_diff.hpp"

using namespace xgm;
using xgm::testing::Random;

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Half of the pixels as in `map`, the others moved, gone or new.
cv::Mat1f changed(const cv::Mat1f& map, std::uint64_t seed) {
  Random random(seed);
  cv::Mat1f result = map.clone();
  for (float& value : result) {
    const int kind = random.integer(0, 7);
    if (kind < 2) value += static_cast<float>(random.real(-3, 3));
    if (kind == 2) value = kNone;
    if (kind == 3 && std::isnan(value)) value = static_cast<float>(random.real(0, 60));
  }
  return result;
}

cv::Mat1f random_map(cv::Size size, std::uint64_t seed) {
  Random random(seed);
  cv::Mat1f map(size);
  for (float& value : map) value = static_cast<float>(random.real(0, 60));
  for (float& value : map) value = random.integer(0, 4) == 0 ? kNone : value;
  return map;
}

}  // namespace

TEST_CASE("diff of maps: the counts are those of a plain loop over the pixels") {
  const cv::Size size(75, 50);
  for (const double threshold : {0.0, 1.0}) {
    const cv::Mat1f a = random_map(size, 1), b = changed(a, 2);
    std::int64_t moved = 0, only_a = 0, only_b = 0, both = 0;
    double sum = 0, largest = 0;
    int left = size.width, right = -1, top = size.height, bottom = -1;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const bool in_a = !std::isnan(a(y, x)), in_b = !std::isnan(b(y, x));
        const double difference = in_a && in_b ? std::abs(double{a(y, x)} - b(y, x)) : 0;
        const bool is_moved = difference > threshold;
        moved += is_moved ? 1 : 0;
        only_a += in_a && !in_b ? 1 : 0;
        only_b += in_b && !in_a ? 1 : 0;
        both += in_a && in_b ? 1 : 0;
        sum += difference;
        largest = std::max(largest, difference);
        if (!is_moved && in_a == in_b) continue;
        left = std::min(left, x), right = std::max(right, x);
        top = std::min(top, y), bottom = std::max(bottom, y);
      }
    }
    const MapDifference diff = compare_maps(a, b, threshold);
    CHECK(diff.pixels == size.area());
    CHECK(diff.moved == moved);
    CHECK(diff.only_first == only_a);
    CHECK(diff.only_second == only_b);
    CHECK(diff.differing() == moved + only_a + only_b);
    CHECK(diff.mean == doctest::Approx(sum / static_cast<double>(both)));
    CHECK(diff.largest == largest);
    CHECK(diff.box == cv::Rect(left, top, right - left + 1, bottom - top + 1));
    CHECK(moved > 0);
    CHECK(only_b > 0);
  }
}

TEST_CASE("diff of maps: a map is the same as itself, and order tells which one has a disparity") {
  const cv::Mat1f a = random_map({40, 30}, 3), b = changed(a, 4);
  const MapDifference none = compare_maps(a, a, 0);
  CHECK(none.differing() == 0);
  CHECK(none.box.empty());
  CHECK(none.worst.empty());
  const MapDifference forth = compare_maps(a, b, 0), back = compare_maps(b, a, 0);
  CHECK(forth.only_first == back.only_second);
  CHECK(forth.only_second == back.only_first);
  CHECK_THROWS_AS(compare_maps(a, cv::Mat1f(30, 41, 0.0F), 0), Error);
}

TEST_CASE("diff of maps: the worst places are the squares with the most differing pixels") {
  const cv::Mat1f a(100, 200, 5.0F);
  cv::Mat1f b = a.clone();
  b(cv::Rect(64, 32, 32, 32)) = 9;    // a whole square
  b(cv::Rect(0, 0, 4, 4)) = kNone;    // 16 pixels
  b(cv::Rect(199, 99, 1, 1)) = 1000;  // one, but far
  const MapDifference diff = compare_maps(a, b, 1);
  REQUIRE(diff.worst.size() == 3);
  CHECK(diff.worst[0].square == cv::Rect(64, 32, 32, 32));
  CHECK(diff.worst[0].pixels == 1024);
  CHECK(diff.worst[0].largest == 4);
  CHECK(diff.worst[1].square == cv::Rect(0, 0, 32, 32));
  CHECK(diff.worst[1].largest == 0);
  CHECK(diff.worst[2].square == cv::Rect(192, 96, 8, 4));
  CHECK(diff.worst[2].largest == 995);
}

TEST_CASE("diff of maps: the picture is black where nothing differs, and tells kinds apart") {
  const cv::Mat1f a(60, 80, 5.0F);
  cv::Mat1f b = a.clone(), c = a.clone();
  b(10, 20) = 8;
  b(11, 20) = kNone;
  c(12, 20) = kNone;
  const cv::Mat3b picture = difference_picture(c, b, 0);
  CHECK(picture(0, 0) == cv::Vec3b(0, 0, 0));
  CHECK(picture(10, 20) != cv::Vec3b(0, 0, 0));
  CHECK(picture(11, 20) == cv::Vec3b(255, 255, 255));
  CHECK(picture(12, 20) == cv::Vec3b(128, 128, 128));
}
