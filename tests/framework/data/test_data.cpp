// SPDX-License-Identifier: Apache-2.0
// Ranges, shapes and maps.
#include <cmath>
#include <set>

#include "support/support.hpp"

using namespace xgm;

TEST_CASE("the reverse of a uniform range is its negative") {
  const auto range = DisparityRange::uniform({5, 4}, {-2, 7});
  CHECK(range.reversed().is_uniform());
  CHECK(range.reversed().hull() == Interval{-6, 3});
  CHECK(range.reversed().reversed().hull() == range.hull());
}

TEST_CASE("the reverse of range maps is the hull of all that points at a pixel") {
  for (const cv::Size size : {cv::Size(1, 1), {13, 5}, {70, 20}}) {
    for (const Interval hull : {Interval{-9, 20}, {-300, 300}, {5, 7}, {1000, 2000}}) {
      const auto range = xgm::testing::random_range(size, hull, 3);
      const auto reverse = range.reversed();
      int wrong = 0;
      for (int y = 0; y < size.height; ++y) {
        for (int q = 0; q < size.width; ++q) {
          std::set<int> reached;
          for (int x = 0; x < size.width; ++x) {
            if (range.at(y, x).contains(x - q)) reached.insert(q - x);
          }
          const Interval expected =
              reached.empty() ? Interval{} : Interval{*reached.begin(), *reached.rbegin() + 1};
          wrong += !(reverse.at(y, q) == expected);
        }
      }
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("a range of pixels has each one's interval and the hull of those that are not empty") {
  const auto at = [](int y, int x) {
    return (x + y) % 3 == 0 ? Interval{5, 2} : Interval{x, 9 * y};
  };
  const auto range = DisparityRange::of_pixels({7, 4}, at);
  CHECK(!range.is_uniform());
  CHECK(range.hull() == Interval{0, 27});
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 7; ++x) CHECK(range.at(y, x) == at(y, x));
  CHECK(DisparityRange::of_pixels({3, 2}, [](int, int) { return Interval{}; }).hull().empty());
}

TEST_CASE(
    "a shape lays pixels out one after the other in whole granules, masked and empty ones without "
    "cells") {
  const cv::Size size(7, 6);
  const auto range = xgm::testing::random_range(size, {-5, 9}, 8);
  const cv::Mat1b mask = xgm::testing::random_mask(size, 0.3, 9);
  const VolumeShape shape(range, mask);
  std::int64_t next = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const Interval interval = mask(y, x) != 0 ? range.at(y, x) : Interval{};
      CHECK(shape.offset(y, x) == next);
      CHECK(shape.count(y, x) == interval.size());
      if (!interval.empty()) CHECK(shape.begin(y, x) == interval.begin);
      CHECK(shape.room(y, x) - interval.size() < VolumeShape::kGranule);
      next += (interval.size() + 15) / 16 * 16;
    }
  }
  CHECK(shape.cells() == next);
}

TEST_CASE("a volume may have more cells than 32 bits count") {
  const VolumeShape shape(DisparityRange::uniform({3000, 3000}, {0, 300}));
  CHECK(shape.cells() == 9'000'000 * std::int64_t{304});
  CHECK(shape.offset(2999, 2999) == 9'000'000 * std::int64_t{304} - 304);
}

TEST_CASE("a disparity is finite exactly where the status says so") {
  DisparityMap map({3, 2});
  CHECK(map.density() == 0);
  map.set(0, 1, -4.5f);
  map.set(1, 2, 3, Status::filled);
  CHECK(map.density() == doctest::Approx(2.0 / 6));
  map.invalidate(0, 1, Status::peak);
  CHECK(std::isnan(map.disparity(0, 1)));
  CHECK(map.at(0, 1) == Status::peak);
  const DisparityMap copy = map.clone();
  map.set(1, 2, 9);
  CHECK(copy.disparity(1, 2) == 3);
  for (int s = 0; s < kStatusCount; ++s) CHECK(!to_string(static_cast<Status>(s)).empty());
}

TEST_CASE("a map inherits the confidence of what is still matched, in memory of its own") {
  DisparityMap origin({3, 1});
  for (int x = 0; x < 3; ++x) origin.set(0, x, 1);
  origin.confidence = cv::Mat1f(1, 3, 0.5F);
  DisparityMap made({3, 1});
  made.set(0, 0, 2);
  made.set(0, 1, 2, Status::filled);
  made.inherit_confidence(origin);
  CHECK(made.confidence(0, 0) == 0.5F);
  CHECK(std::isnan(made.confidence(0, 1)));
  CHECK(std::isnan(made.confidence(0, 2)));
  CHECK(origin.confidence(0, 1) == 0.5F);
  DisparityMap judged = made.clone();
  judged.confidence(0, 0) = 0.75F;
  judged.inherit_confidence(origin);
  CHECK(judged.confidence(0, 0) == 0.75F);  // its own
  CHECK(made.confidence(0, 0) == 0.5F);
  DisparityMap plain({3, 1});
  plain.inherit_confidence(DisparityMap({3, 1}));
  CHECK(plain.confidence.empty());
  CHECK(made.bytes() == 3 * (4 + 1 + 4));
}

TEST_CASE("grey is the luma of blue, green, red") {
  Image image;
  for (const float value : {10.f, 20.f, 30.f}) image.planes.emplace_back(1, 1, value);
  CHECK(image.grey()(0, 0) == doctest::Approx(0.114 * 10 + 0.587 * 20 + 0.299 * 30));
}

TEST_CASE("a pixel's grey does not depend on the rows that are computed with it") {
  // Contiguous or not, of sizes that leave rests of vectors.
  for (const cv::Size size : {cv::Size(1, 300), {37, 65}, {130, 131}}) {
    for (const bool contiguous : {true, false}) {
      CAPTURE(size);
      CAPTURE(contiguous);
      cv::RNG random(7);
      Image image;
      for (int k = 0; k < 3; ++k) {
        cv::Mat1f large(size.height + 2, size.width + 3);
        random.fill(large, cv::RNG::UNIFORM, 0, 255);
        const cv::Mat1f part = large(cv::Rect({2, 1}, size));
        image.planes.push_back(contiguous ? part.clone() : part);
      }
      const cv::Mat1f whole(image.planes[0] * 0.114f + image.planes[1] * 0.587f +
                            image.planes[2] * 0.299f);
      CHECK(cv::countNonZero(image.grey() != whole) == 0);
    }
  }
}
