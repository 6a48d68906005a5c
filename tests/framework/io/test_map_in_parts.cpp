// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/data/crop.hpp"
#include "xgm/data/image_parts.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/map_in_parts.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/write_maps.hpp"

using namespace xgm;
using xgm::testing::error_of;
using xgm::testing::Random;
using xgm::testing::TemporaryFolder;

namespace {

constexpr double kAnySize = std::numeric_limits<double>::infinity();

DisparityMap random_map(cv::Size size) {
  DisparityMap map(size);
  Random random(3);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto status = static_cast<Status>(random.integer(0, kStatusCount - 1));
      if (has_disparity(status)) {
        map.set(y, x, static_cast<float>(random.integer(-40, 400)) / 8, status);
      } else {
        map.invalidate(y, x, status);
      }
    }
  }
  return map;
}

void give_parts(const DisparityMap& map, MapInParts& parts) {
  std::vector<cv::Rect> places = image_parts(map.size(), {40, 30});
  std::reverse(places.begin(), places.end());
  for (const cv::Rect& place : places) parts.take(place, crop(map, place));
}

}  // namespace

TEST_CASE("a map that is written in parts, in any order, gives the files of the whole") {
  for (const cv::Size size : {cv::Size(130, 97), cv::Size(1, 1), cv::Size(33000, 3)}) {
    CAPTURE(size.width);
    const DisparityMap map = random_map(size);
    const TemporaryFolder whole, folder;
    write_maps(whole.path(), map);
    MapInParts parts(folder.path(), size, {-5, 51}, kAnySize);
    give_parts(map, parts);
    CHECK(folder.files() == 0);  // none is seen before it is complete
    parts.finish();
    for (const char* name : kMapFiles) CHECK(read_file(folder / name) == read_file(whole / name));
    CHECK(parts.summary().density() == map.density());
    CHECK(parts.summary().status_shares() == status_shares(map));
  }
}

TEST_CASE("the confidence of a map in parts is that of the whole, and none if there is none") {
  DisparityMap map = random_map({130, 97});
  const TemporaryFolder whole, folder;
  const std::string file = folder / kConfidenceFile;
  for (const bool has_confidence : {true, false}) {
    map.confidence.release();
    if (has_confidence) {
      map.confidence = map.disparity / 400;
      map.confidence.setTo(std::numeric_limits<float>::quiet_NaN(), map.status != 0);
    }
    write_maps(whole.path(), map);
    MapInParts parts(folder.path(), map.size(), {-5, 51}, kAnySize);
    give_parts(map, parts);
    CHECK(parts.has_confidence() == has_confidence);
    parts.finish();
    CHECK(std::filesystem::exists(whole / kConfidenceFile) == has_confidence);
    CHECK(std::filesystem::exists(file) == has_confidence);  // that of the map before is removed
    if (has_confidence) CHECK(read_file(file) == read_file(whole / kConfidenceFile));
  }
}

TEST_CASE("the summary of parts counts what is matched within 1 px of the ends of the search") {
  const DisparityMap map = random_map({130, 97});
  MapSummary summary({-5, 51});
  for (const cv::Rect& place : image_parts(map.size(), {17, 23})) summary.add(crop(map, place));
  double matched = 0, first = 0, last = 0;
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (map.at(y, x) != Status::matched) continue;
      ++matched;
      first += std::abs(map.disparity(y, x) + 5) < 1;
      last += std::abs(map.disparity(y, x) - 50) < 1;
    }
  }
  REQUIRE(first > 0);
  CHECK(summary.share_at_first() == first / matched);
  CHECK(summary.share_at_last() == last / matched);
}

TEST_CASE("pictures of a map in parts show fewer pixels where they are to be small") {
  const DisparityMap map = random_map({130, 97});
  const TemporaryFolder folder;
  const double bytes =
      MapInParts::held_bytes(map.size(), 1000) + MapInParts::finish_bytes(map.size(), 1000);
  CHECK(bytes < MapInParts::held_bytes(map.size(), kAnySize) +
                    MapInParts::finish_bytes(map.size(), kAnySize));
  MapInParts parts(folder.path(), map.size(), {}, 1000);
  give_parts(map, parts);
  parts.finish();
  CHECK(read_map(folder / "disparity.pfm").value.size() == map.size());
  // The shares in the legend are those of all pixels, the colours those of each fourth one.
  const Sampling sampling = Sampling::within(map.size(), 1000);
  DisparityMap shown;
  shown.disparity = sampled(map.disparity, sampling);
  shown.status = sampled(map.status, sampling);
  write_png(folder / "expected.png", status_picture(shown, status_shares(map)));
  CHECK(read_file(folder / "status.png") == read_file(folder / "expected.png"));
}

TEST_CASE("a map of which parts are missing leaves no file, and one that ends early none, too") {
  const TemporaryFolder folder;
  {
    MapInParts parts(folder.path(), {50, 40}, {}, kAnySize);
    parts.take({0, 0, 50, 39}, DisparityMap({50, 39}));
    CHECK(
        xgm::testing::contains(error_of([&] { parts.finish(); }), "parts of the map are missing"));
  }
  CHECK(folder.files() == 0);
  CHECK(xgm::testing::contains(error_of([&] {
                                 MapInParts(folder / "no_folder", {50, 40}, {}, kAnySize);
                               }),
                               "cannot be written"));
}
