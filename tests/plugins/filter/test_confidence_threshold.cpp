// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/plugins/maps.hpp"
#include "tests/support/support.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A row of matched pixels with these confidences.
DisparityMap row(const std::vector<float>& confidences) {
  DisparityMap map({static_cast<int>(confidences.size()), 1});
  map.confidence.create(map.size());
  for (int x = 0; x < map.size().width; ++x) {
    map.set(0, x, static_cast<float>(x));
    map.confidence(0, x) = confidences[static_cast<std::size_t>(x)];
  }
  return map;
}

/// "x" for each pixel that is kept, "." for each that is not.
std::string kept(const std::string& yaml, const DisparityMap& map) {
  const DisparityMap result = stage<Filter>(yaml)->run(map, {}, {});
  CHECK(is_consistent(result));
  std::string text;
  for (int x = 0; x < map.size().width; ++x) {
    text += result.has_disparity(0, x) ? 'x' : '.';
    if (result.has_disparity(0, x)) {
      CHECK(result.disparity(0, x) == map.disparity(0, x));
    } else if (map.has_disparity(0, x)) {
      CHECK(result.at(0, x) == Status::ambiguous);
    } else {
      CHECK(result.at(0, x) == map.at(0, x));
    }
  }
  return text;
}

}  // namespace

TEST_CASE(
    "confidence_threshold takes away what is less sure than min, and what has no confidence") {
  const DisparityMap map = row({0, 0.5F, 0.499F, 1, kNaN});
  CHECK(kept("{type: confidence_threshold, min: 0.5}", map) == ".x.x.");
  CHECK(kept("{type: confidence_threshold, min: 1}", map) == "...x.");
}

TEST_CASE("confidence_threshold keeps a share of the surest, ties included") {
  const DisparityMap map = row({0.1F, 0.9F, 0.5F, 0.5F, kNaN, 0.3F, 0.7F, 0.2F, 0, 0.4F});
  CHECK(kept("{type: confidence_threshold, keep: 0.1}", map) == ".x........");
  CHECK(kept("{type: confidence_threshold, keep: 0.25}", map) == ".xxx..x...");
  CHECK(kept("{type: confidence_threshold, keep: 0.9}", map) == "xxxx.xxxxx");
  CHECK(kept("{type: confidence_threshold, keep: 0}", map) == "..........");
  CHECK(kept("{type: confidence_threshold, keep: 0.9, min: 0.4}", map) == ".xxx..x..x");
}

TEST_CASE("confidence_threshold counts only pixels that have a disparity") {
  DisparityMap map = row({0.9F, 0.8F, 0.7F, 0.6F});
  map.invalidate(0, 0, Status::occluded);
  map.invalidate(0, 1, Status::peak);
  CHECK(kept("{type: confidence_threshold, keep: 0.5}", map) == "..x.");
}

TEST_CASE("confidence_threshold: filled pixels go before matched ones, however unsure") {
  DisparityMap map = row({0.01F, 0.9F, 0.5F, 0.2F});
  map.set(0, 1, 4, Status::filled);
  DisparityMap filtered = map;
  filtered.inherit_confidence(map);
  CHECK(kept("{type: confidence_threshold, keep: 0.75}", filtered) == "x.xx");
}

TEST_CASE("confidence_threshold says what is missing if nobody looked before") {
  DisparityMap map = row({1, 0});
  map.confidence.release();
  CHECK_THROWS_AS(stage<Filter>("{type: confidence_threshold, keep: 0.5}")->run(map, {}, {}),
                  Error);
}

TEST_CASE("confidence_threshold that keeps everything is a mistake, and so are unsure numbers") {
  for (const char* faulty :
       {"confidence_threshold", "{type: confidence_threshold, min: 0}",
        "{type: confidence_threshold, min: 1.5}", "{type: confidence_threshold, keep: -0.1}"}) {
    CHECK_THROWS_AS(stage<Filter>(faulty), UsageError);
  }
}
