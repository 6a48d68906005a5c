// SPDX-License-Identifier: Apache-2.0
// Maps and costs that are there already.
#include <doctest/doctest.h>

#include <filesystem>

#include "external/programs.hpp"
#include "tests/plugins/maps.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/pfm.hpp"
#include "xgm/stage/slot.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

const cv::Size kSize(12, 7);
const RunFacts kField{.scene = "Field", .calibration = {}};

MatchRequest request(bool is_reverse = false) {
  const ImagePair pair{random_image(kSize, 1), random_image(kSize, 2), is_reverse};
  const Interval range = is_reverse ? Interval{-7, 1} : Interval{0, 8};
  return {pair, DisparityRange::uniform(kSize, range), std::nullopt};
}

DisparityMap matched(const std::string& parameters, const MatchRequest& asked,
                     const Context& context = Context().with(kField)) {
  const Slot<Matcher> slot(stage<Matcher>("{type: precomputed, " + parameters + "}"));
  return slot(context, asked).forward;
}

std::string error_with(const std::string& parameters, const MatchRequest& asked = request(),
                       const Context& context = Context().with(kField)) {
  return error_of([&] { matched(parameters, asked, context); });
}

}  // namespace

TEST_CASE("precomputed reads the map of the scene, its view and its level") {
  const TemporaryFolder desk;
  write_pfm(desk / "Field_left_1.pfm", cv::Mat1f(kSize, 2.5F));
  write_pfm(desk / "Field_right_1.pfm", cv::Mat1f(kSize, -3.5F));
  write_pfm(desk / "Field_left_4.pfm", cv::Mat1f(kSize, 1));
  const std::string file = "file: '" + (desk / "{scene}_{view}_{scale}.pfm") + "'";
  CHECK(matched(file, request()).disparity(3, 3) == 2.5F);
  CHECK(matched(file, request(true)).disparity(3, 3) == -3.5F);
  const Context level = Context().with(kField).level("s4", 4);
  CHECK(matched(file, request(), level).disparity(3, 3) == 1);
}

TEST_CASE("precomputed reads whole numbers by their divisor, of either sign") {
  const TemporaryFolder desk;
  write_png(desk / "left.png", cv::Mat1w(kSize, std::uint16_t{512}));
  write_png(desk / "right.png", cv::Mat1w(kSize, std::uint16_t{768}));
  const std::string file =
      "file: '" + (desk / "{view}.png") + "', divisor: 256, reverse_divisor: -256";
  CHECK(matched(file, request()).disparity(3, 3) == 2);
  CHECK(matched(file, request(true)).disparity(3, 3) == -3);
}

TEST_CASE("precomputed: what is outside of the range, or not finite, is no disparity") {
  const TemporaryFolder desk;
  cv::Mat1f values(kSize, 4.0F);
  values(0, 0) = 9;
  values(0, 1) = std::numeric_limits<float>::quiet_NaN();
  write_pfm(desk / "map.pfm", values);
  MatchRequest asked = request();
  asked.pair.base.valid = cv::Mat1b(kSize, std::uint8_t{255});
  asked.pair.base.valid(0, 2) = 0;
  const DisparityMap map = matched("file: '" + (desk / "map.pfm") + "'", asked);
  CHECK(map.at(0, 0) == Status::out_of_range);
  CHECK(map.at(0, 1) == Status::out_of_range);
  CHECK(map.at(0, 2) == Status::masked);
  CHECK(map.disparity(0, 3) == 4);
}

TEST_CASE("precomputed brings a confidence along") {
  const TemporaryFolder desk;
  write_pfm(desk / "map.pfm", cv::Mat1f(kSize, 4.0F));
  write_pfm(desk / "sure.pfm", cv::Mat1f(kSize, 0.75F));
  const std::string files =
      "file: '" + (desk / "map.pfm") + "', confidence: '" + (desk / "sure.pfm") + "'";
  CHECK(stage<Matcher>("{type: precomputed, " + files + "}")->gives_confidence());
  CHECK(matched(files, request()).confidence(3, 3) == 0.75F);
}

TEST_CASE("precomputed: each file that does not fit is one error that says why") {
  const TemporaryFolder desk;
  write_pfm(desk / "map.pfm", cv::Mat1f(kSize, 4.0F));
  write_pfm(desk / "small.pfm", cv::Mat1f(3, 3, 4.0F));
  write_pfm(desk / "empty.pfm", cv::Mat1f(kSize, std::numeric_limits<float>::quiet_NaN()));
  const auto named = [&](const std::string& name) { return "file: '" + (desk / name) + "'"; };
  CHECK(contains(error_with(named("missing.pfm")), "missing.pfm: no such file"));
  CHECK(contains(error_with(named("small.pfm")), "is 3 x 3, and the images are 12 x 7"));
  CHECK(contains(error_with(named("empty.pfm")), "holds no finite disparity"));
  CHECK(contains(error_with(named("map.pfm"), request(true)), "one file for both views"));
  const Context level = Context().with(kField).level("s4", 4);
  CHECK(contains(error_with(named("map.pfm"), request(), level), "one file for all levels"));
  CHECK(contains(error_with(named("{scene}.pfm"), request(), Context()), "these images have none"));
  CHECK_THROWS_AS(stage<Matcher>("precomputed"), UsageError);
}

TEST_CASE("precomputed costs are those of the file, from its first disparity on") {
  const TemporaryFolder desk;
  cv::Mat numbers(kSize, CV_32FC4, cv::Scalar(1, 2, 3, 4));
  write_npy(desk / "Field_left.npy", numbers);
  const std::string file = "{type: precomputed, file: '" + (desk / "{scene}_{view}.npy") + "'";
  const auto shape = std::make_shared<const VolumeShape>(DisparityRange::uniform(kSize, {3, 5}));
  const auto run = [&](const std::string& parameters) {
    return Slot<Cost>(stage<Cost>(file + parameters + "}"))(Context().with(kField), request().pair,
                                                            shape);
  };
  const CostVolume volume = run(", first: 2, scale: 10");
  CHECK(volume.at(3, 8)[0] == 20);
  CHECK(volume.at(3, 8)[1] == 30);
  CHECK(volume.at(3, 3)[1] == CostVolume::kNoMatch);
  CHECK(contains(error_of([&] { run(", first: 4"); }),
                 "has the disparities 4 to 7, and 3 to 4 are searched"));
}

TEST_CASE("precomputed reads nothing in a rehearsal, whose images are smaller") {
  const RunFacts facts{.scene = "Field", .calibration = {}, .rehearsal = true};
  const Context rehearsal = Context().with(facts);
  CHECK(matched("file: missing.pfm", request(), rehearsal).density() > 0.5);
  const auto shape = std::make_shared<const VolumeShape>(request().range);
  const CostVolume volume =
      stage<Cost>("{type: precomputed, file: missing.npy}")->run(request().pair, shape, rehearsal);
  CHECK(volume.at(3, 8)[0] == 0);
}
