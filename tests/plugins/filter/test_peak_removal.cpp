// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "tests/plugins/maps.hpp"
#include "tests/support/support.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/plugin.hpp"

using xgm::DisparityMap;
using xgm::Status;
using xgm::testing::identical;

namespace {

DisparityMap run(int min_size, double max_difference, const DisparityMap& map) {
  const std::string yaml = "{type: peak_removal, min_size: " + std::to_string(min_size) +
                           ", max_difference: " + std::to_string(max_difference) + "}";
  return xgm::testing::stage<xgm::Filter>(yaml)->run(map, {}, xgm::Context{});
}

/// Labels spread from neighbour to neighbour until nothing changes; then sizes are counted.
DisparityMap oracle(int min_size, double max_difference, const DisparityMap& map) {
  cv::Mat1i label(map.size(), -1);
  for (int i = 0; i < static_cast<int>(label.total()); ++i) {
    if (map.has_disparity(i / label.cols, i % label.cols))
      label(i / label.cols, i % label.cols) = i;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < label.rows; ++y) {
      for (int x = 0; x < label.cols; ++x) {
        for (const auto& [v, u] : {std::pair(y, x + 1), {y, x - 1}, {y + 1, x}, {y - 1, x}}) {
          if (v < 0 || u < 0 || v >= label.rows || u >= label.cols) continue;
          if (label(y, x) < 0 || label(v, u) <= label(y, x)) continue;
          const double difference = static_cast<double>(map.disparity(y, x)) - map.disparity(v, u);
          if (std::abs(difference) > max_difference) continue;
          label(v, u) = label(y, x);
          changed = true;
        }
      }
    }
  }
  DisparityMap result = map.clone();
  for (int y = 0; y < label.rows; ++y) {
    for (int x = 0; x < label.cols; ++x) {
      const int size = cv::countNonZero(label == label(y, x));
      if (map.has_disparity(y, x) && size < min_size) result.invalidate(y, x, Status::peak);
    }
  }
  return result;
}

}  // namespace

TEST_CASE("peak_removal invalidates the segments of the definition") {
  for (const cv::Size size : xgm::testing::kMapSizes) {
    for (const int min_size : {1, 2, 4, 10, 1000000}) {
      for (const double difference : {0.0, 0.5, 1.0, 2.0}) {
        CAPTURE(size);
        CAPTURE(min_size);
        CAPTURE(difference);
        const DisparityMap map = xgm::testing::random_map(size, {-2, 2, 0.5, 0.2}, 9);
        CHECK(identical(run(min_size, difference, map), oracle(min_size, difference, map)));
      }
    }
  }
}

TEST_CASE("peak_removal joins segments across all rows of a tall map") {
  const DisparityMap map = xgm::testing::random_map({9, 200}, {-2, 2, 0.5, 0.25}, 10);
  for (const int threads : {1, 3}) {
    const xgm::ThreadLimit limit(threads);
    CHECK(identical(run(12, 1, map), oracle(12, 1, map)));
  }
}

TEST_CASE("peak_removal: a slope is one segment, diagonal neighbours are two") {
  const DisparityMap slope = xgm::testing::drawn_map({"0123456789"});
  CHECK(identical(run(10, 1, slope), slope));
  const DisparityMap diagonal = xgm::testing::drawn_map({"9.", ".9"});
  CHECK(run(2, 1, diagonal).density() == 0.0);
}

TEST_CASE("peak_removal keeps a segment of exactly min_size and a winding one") {
  const DisparityMap map = xgm::testing::drawn_map({"55500", "00500", "05500", "05000", "05555"});
  const DisparityMap result = run(11, 1, map);
  CHECK(result.has_disparity(0, 0));
  CHECK(result.has_disparity(4, 4));
  CHECK(result.at(4, 0) == Status::peak);
  CHECK(run(12, 1, map).at(0, 0) == Status::peak);
}

TEST_CASE("peak_removal done twice is peak_removal done once") {
  const DisparityMap map = xgm::testing::random_map({31, 22}, {-3, 3, 1, 0.2}, 4);
  const DisparityMap once = run(6, 1, map);
  CHECK(identical(run(6, 1, once), once));
  CHECK(once.density() < map.density());
}

TEST_CASE("peak_removal needs no stack for a segment of a million pixels") {
  DisparityMap map(cv::Size(1500, 1000));
  for (int y = 0; y < 1000; ++y) {
    for (int x = 0; x < 1500; ++x) map.set(y, x, static_cast<float>(x / 2));
  }
  CHECK(run(1500 * 1000, 1, map).density() == 1.0);
  CHECK(run(1500 * 1000 + 1, 1, map).density() == 0.0);
}
