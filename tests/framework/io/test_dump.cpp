// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/dump.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::TemporaryFolder;

TEST_CASE("dump: patterns match whole paths, stars cross dots, brackets may be meant literally") {
  CHECK(Dumper("", "*").wants("matcher.cost"));
  CHECK(Dumper("", "*.cost").wants("matcher.matcher.cost"));
  CHECK_FALSE(Dumper("", "*.cost").wants("matcher.cost.x"));
  CHECK_FALSE(Dumper("", "cost").wants("matcher.cost"));
  CHECK(Dumper("", "postprocess[0]").wants("postprocess[0]"));
  CHECK_FALSE(Dumper("", "").wants(""));
}

TEST_CASE("dump: a ragged volume is a dense .npy whose gaps are the largest value") {
  const TemporaryFolder folder;
  const DisparityRange range((cv::Mat1i(1, 2) << -2, 0), (cv::Mat1i(1, 2) << 0, 1));
  AggregatedVolume volume(std::make_shared<VolumeShape>(range), 0);
  volume.at(0, 0)[0] = 7;
  volume.at(0, 0)[1] = 8;
  volume.at(0, 1)[0] = 9;
  Dumper dumper(folder.path(), "*");
  dumper.write("matcher.aggregation", &volume);
  REQUIRE(dumper.files().size() == 1);
  CHECK(dumper.files()[0].first_disparity == -2);
  const std::string bytes = read_file(folder / "matcher.aggregation.npy");
  CHECK(bytes.starts_with("\x93NUMPY"));
  CHECK(contains(bytes, "'shape': (1, 2, 3)"));
  CHECK(contains(bytes, "u2'"));
  std::uint16_t cells[6];
  REQUIRE((bytes.size() - sizeof cells) % 64 == 0);
  std::memcpy(cells, bytes.data() + bytes.size() - sizeof cells, sizeof cells);
  const std::uint16_t expected[6] = {7, 8, 65535, 65535, 65535, 9};
  CHECK(std::memcmp(cells, expected, sizeof cells) == 0);
}

TEST_CASE("dump: ranges can be given back as range maps, empty staying empty") {
  const TemporaryFolder folder;
  const DisparityRange range((cv::Mat1i(1, 2) << -2, 0), (cv::Mat1i(1, 2) << 3, 0));
  Dumper dumper(folder.path(), "*");
  dumper.write("range", &range);
  CHECK(read_pfm(folder / "range.min.pfm")(0, 0) == -2);
  CHECK(read_pfm(folder / "range.max.pfm")(0, 0) == 2);
  CHECK(std::isnan(read_pfm(folder / "range.min.pfm")(0, 1)));
}

TEST_CASE("dump: maps of both views; a stage that runs twice keeps both results") {
  const TemporaryFolder folder;
  MatchResult result{DisparityMap({2, 2}), DisparityMap({2, 2})};
  Dumper dumper(folder / "made/when/needed", "*");
  dumper.write("matcher", &result);
  dumper.write("matcher", &result);
  CHECK(dumper.files().size() == 8);
  CHECK_NOTHROW(read_pfm(folder / "made/when/needed/matcher.reverse.disparity.pfm"));
  CHECK_NOTHROW(read_pfm(folder / "made/when/needed/matcher.2.forward.disparity.pfm"));
  dumper.write("penalty", std::monostate());
  CHECK(dumper.files().size() == 8);
}
