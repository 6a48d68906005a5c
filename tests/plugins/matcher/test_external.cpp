// SPDX-License-Identifier: Apache-2.0
// Matchers that are programs of others: what they are given, and what becomes of their answers.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "external/programs.hpp"
#include "tests/plugins/maps.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/pfm.hpp"
#include "xgm/stage/slot.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
const cv::Size kSize(12, 7);

MatchRequest request(Interval range = {-2, 5}) {
  return {{random_image(kSize, 1, 3), random_image(kSize, 2, 3)},
          DisparityRange::uniform(kSize, range),
          std::nullopt};
}

/// A number of each pixel.
cv::Mat1f answer() {
  cv::Mat1f values(kSize);
  for (int y = 0; y < values.rows; ++y) {
    for (int x = 0; x < values.cols; ++x) values(y, x) = static_cast<float>(x % 5) + 0.25F;
  }
  return values;
}

std::shared_ptr<const Matcher> external(const std::string& parameters) {
  return stage<Matcher>("{type: external, " + parameters + "}");
}

/// As a run does: the result is looked at.
DisparityMap matched(const std::string& parameters, const MatchRequest& asked) {
  return Slot<Matcher>(external(parameters))(Context(), asked).forward;
}

std::string error_with(const std::string& parameters) {
  return error_of([&] { matched(parameters, request()); });
}

}  // namespace

TEST_CASE("an external matcher is given images, range and what is known of the scene") {
  const TemporaryFolder desk;
  write_npy(desk / "disparity.npy", answer());
  MatchRequest asked = request();
  asked.pair.base.valid = random_mask(kSize, 0.3, 4);
  const RunFacts facts{.scene = "Field", .calibration = Calibration{100, 6, 3, 2, 50}};
  const Context context = Context().with(facts);
  const DisparityMap map =
      external(keep_and_answer(desk, "disparity.npy"))->run(asked, context).forward;
  const Json json = request_in(desk);
  CHECK(json.at("xgm_exchange").number() == 1);
  CHECK(json.at("kind").text() == "matcher");
  CHECK(json.at("scene").text() == "Field");
  CHECK(json.at("view").text() == "left");
  CHECK(json.at("disparities").dump() == "[-2,4]");
  CHECK(json.at("width").number() == 12);
  CHECK(json.at("height").number() == 7);
  CHECK(json.at("calibration").at("cx").number() == 6);
  CHECK_FALSE(std::filesystem::exists(json.at("folder").text()));
  const ImagePair given = read_pair({.left = desk / "given/base.png",
                                     .right = desk / "given/match.png",
                                     .left_mask = desk / "given/base_mask.png"})
                              .pair;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      CHECK(given.match.planes[2](y, x) == asked.pair.match.planes[2](y, x));
      CHECK(given.base.is_valid(y, x) == asked.pair.base.is_valid(y, x));
      if (asked.pair.base.is_valid(y, x)) {
        CHECK(map.disparity(y, x) == answer()(y, x));
      } else {
        CHECK(map.at(y, x) == Status::masked);
      }
    }
  }
}

TEST_CASE("grey levels are handed over as they are, if they are asked for as arrays") {
  const TemporaryFolder desk;
  write_npy(desk / "disparity.npy", answer());
  MatchRequest asked = request();
  asked.pair = {Image(cv::Mat1f(kSize, 0.125F)), Image(cv::Mat1f(kSize, 200.5F))};
  matched(keep_and_answer(desk, "disparity.npy") + ", images: npy", asked);
  CHECK(request_in(desk).at("base").at("image").text() == "base.npy");
  CHECK(array_in(desk / "given/base.npy")(3, 3) == 0.125F);
  CHECK(array_in(desk / "given/match.npy")(3, 3) == 200.5F);
  matched(keep_and_answer(desk, "disparity.npy") + ", images: npy", request());
  const NpyArray colour = read_npy(desk / "given/base.npy");
  REQUIRE(colour.shape == std::vector<std::size_t>{7, 12, 3});
  CHECK(colour.at(3) == static_cast<double>(request().pair.base.planes[2](0, 1)));  // red
}

TEST_CASE("the right view is handed over mirrored, and its answer is turned back") {
  const TemporaryFolder desk;
  write_npy(desk / "disparity.npy", answer());
  MatchRequest asked = request({-4, 3});
  asked.pair = asked.pair.swapped();
  const RunFacts facts{.scene = "", .calibration = Calibration{100, 6, 3, 2, 50}};
  const DisparityMap map =
      external(keep_and_answer(desk, "disparity.npy"))->run(asked, Context().with(facts)).forward;
  CHECK(request_in(desk).at("view").text() == "right");
  CHECK(request_in(desk).at("disparities").dump() == "[-2,4]");
  CHECK(request_in(desk).at("calibration").at("cx").number() == 11 - 8);
  const ImagePair given =
      read_pair({.left = desk / "given/base.png", .right = desk / "given/match.png"}).pair;
  for (int x = 0; x < kSize.width; ++x) {
    CHECK(given.base.planes[0](2, x) == asked.pair.base.planes[0](2, 11 - x));
    CHECK(map.disparity(2, x) == -answer()(2, 11 - x));
  }
}

TEST_CASE("an external matcher that finds what a shifted pair hides, alone and in left_right") {
  const ImagePair pair = shifted_pair({40, 30}, 3, 8);
  const MatchRequest asked{pair, DisparityRange::uniform({40, 30}, {0, 8}), std::nullopt};
  CHECK(matched(honest("match"), asked).disparity(15, 20) == 3);
  const MatchResult both =
      stage<Matcher>("{type: left_right, matcher: {type: external, " + honest("match") + "}}")
          ->run(asked, {});
  CHECK(both.forward.disparity(15, 20) == 3);
  CHECK(both.reverse->disparity(15, 20) == -3);
}

TEST_CASE("answers outside of the range, and NaN, are no disparities") {
  const TemporaryFolder desk;
  cv::Mat1f values = answer();
  values(0, 0) = kNaN;
  values(0, 1) = 5;
  values(0, 2) = -3;
  values(0, 3) = std::numeric_limits<float>::infinity();
  write_pfm(desk / "disparity.pfm", values);
  const DisparityMap map = matched(keep_and_answer(desk, "disparity.pfm"), request());
  for (int x = 0; x < 4; ++x) CHECK(map.at(0, x) == Status::out_of_range);
  CHECK(map.disparity(0, 4) == 4.25F);
  CHECK(is_consistent(map));
}

TEST_CASE("ranges per pixel are handed over if the program heeds them, else refused") {
  const TemporaryFolder desk;
  write_npy(desk / "disparity.npy", answer());
  MatchRequest asked = request();
  asked.range = random_range(kSize, {-2, 5}, 6);
  const std::string parameters = keep_and_answer(desk, "disparity.npy");
  CHECK_FALSE(external(parameters)->accepts_range_maps());
  CHECK(contains(error_of([&] { matched(parameters, asked); }), "one for the whole image"));
  CHECK(external(parameters + ", range_maps: true")->accepts_range_maps());
  const DisparityMap map = matched(parameters + ", range_maps: true", asked);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const Interval own = asked.range.at(y, x);
      if (own.empty()) CHECK_FALSE(map.has_disparity(y, x));
      if (map.has_disparity(y, x)) CHECK(map.disparity(y, x) > static_cast<float>(own.begin) - 1);
    }
  }
  CHECK(std::filesystem::exists(desk / "given/first.npy"));
  CHECK(request_in(desk).at("range").at("last").text() == "last.npy");
}

TEST_CASE("a confidence of the program goes with its map, and is missed if it was promised") {
  const TemporaryFolder desk;
  write_npy(desk / "disparity.npy", answer());
  write_npy(desk / "confidence.npy", cv::Mat1f(kSize, 0.5F));
  const std::string both = command(desk, "cp '" + (desk / "disparity.npy") + "' '" +
                                             (desk / "confidence.npy") + "' \"$folder\"");
  CHECK(external(both + ", confidence: true")->gives_confidence());
  CHECK(matched(both + ", confidence: true", request()).confidence(3, 3) == 0.5F);
  CHECK(matched(both, request()).confidence.empty());
  const std::string one = command(desk, "cp '" + (desk / "disparity.npy") + "' \"$folder\"");
  CHECK(contains(error_with(one + ", confidence: true"), "wrote neither confidence.npy nor"));
  write_npy(desk / "confidence.npy", cv::Mat1f(kSize, 1.5F));
  const std::string wrong = command(desk, "cp '" + (desk / "disparity.npy") + "' '" +
                                              (desk / "confidence.npy") + "' \"$folder\"");
  CHECK(contains(error_with(wrong + ", confidence: true"), "a confidence is not in 0 to 1"));
}

TEST_CASE("each fault of a program is one error that names the stage") {
  const TemporaryFolder desk;
  const auto check = [&](const std::string& script, const std::string& what) {
    const std::string error = error_with(command(desk, script) + ", time_limit: 0.5");
    INFO(error);
    CHECK(error.starts_with("matcher: "));
    CHECK(contains(error, what));
    CHECK(error.find('\n') == std::string::npos);
  };
  write_npy(desk / "whole.npy", answer());
  write_npy(desk / "small.npy", cv::Mat1f(3, 3, 1.0F));
  write_npy(desk / "nothing.npy", cv::Mat1f(kSize, kNaN));
  write_npy(desk / "whole_numbers.npy", cv::Mat1i(kSize, 1));
  const auto answer_with = [&](const std::string& name) {
    return "cp '" + (desk / name) + "' \"$folder/disparity.npy\"";
  };
  check("sleep 100", "did not end within 0.5 s");
  check("exit 7", "failed with exit code 7");
  check("kill -ABRT $$", "was ended by signal 6");
  check("exit 0", "wrote neither disparity.npy nor disparity.pfm");
  check("head -c 200 '" + (desk / "whole.npy") + "' > \"$folder/disparity.npy\"", "is cut short");
  check("head -c 20 '" + (desk / "whole.npy") + "' > \"$folder/disparity.npy\"", "is cut short");
  check(answer_with("small.npy"), "of the shape (3, 3), and (7, 12) is wanted");
  check(answer_with("nothing.npy"), "holds no finite disparity");
  check(answer_with("whole_numbers.npy"), "write float32, float64 or uint8");
  check("echo text > \"$folder/disparity.npy\"", "is no file of NumPy");
  check(": > \"$folder/disparity.npy\"", "is empty");
}

TEST_CASE("no folder of a request is left, whatever its program does") {
  const TemporaryFolder desk, temporary;
  ::setenv("TMPDIR", temporary.path().c_str(), 1);
  for (const char* script :
       {"exit 1", "mkdir \"$folder/more\"; echo x > \"$folder/more/x\"; exit 0", "kill -KILL $$",
        "rm -rf \"$folder\""}) {
    CHECK(error_with(command(desk, script)) != "");
    CHECK(temporary.files() == 0);
  }
  ::setenv("TMPDIR", (temporary / "missing").c_str(), 1);
  const std::string error = error_with(command(desk, "exit 0"));
  ::unsetenv("TMPDIR");
  CHECK(contains(error, "TMPDIR"));
}

TEST_CASE("a rehearsal starts no program") {
  const TemporaryFolder desk;
  const RunFacts facts{.scene = "", .calibration = {}, .rehearsal = true};
  const auto matcher = external(command(desk, "echo > '" + (desk / "started") + "'; exit 1"));
  const DisparityMap map = matcher->run(request(), Context().with(facts)).forward;
  CHECK_FALSE(std::filesystem::exists(desk / "started"));
  CHECK(map.density() > 0.5);
}

TEST_CASE("mistakes in the parameters of an external stage are told before it is run") {
  for (const char* faulty :
       {"{type: external}", "{type: external, command: []}", "{type: external, command: python3}",
        "{type: external, command: [[python3]]}", "{type: external, command: ['']}",
        "{type: external, command: [a], time_limit: 0}",
        "{type: external, command: [a], memory_limit: -1}"}) {
    const std::string text = faulty;
    CAPTURE(text);
    CHECK_THROWS_AS(stage<Matcher>(text), UsageError);
  }
  CHECK_NOTHROW(stage<Matcher>("{type: external, command: [a, 1, true, ~x]}"));
}
