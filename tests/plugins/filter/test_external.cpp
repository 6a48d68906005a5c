// SPDX-License-Identifier: Apache-2.0
// Filters that are programs of others.
#include <doctest/doctest.h>

#include <limits>

#include "external/programs.hpp"
#include "tests/plugins/maps.hpp"
#include "xgm/stage/slot.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

DisparityMap filtered(const std::string& parameters, const DisparityMap& map, bool is_reverse,
                      const Context& context = {}) {
  const ImagePair pair{random_image(map.size(), 1), random_image(map.size(), 2), is_reverse};
  return Slot<Filter>(stage<Filter>("{type: external, " + parameters + "}"))(context, map, pair);
}

}  // namespace

TEST_CASE("an external filter takes away, fills and changes; masked pixels stay") {
  const TemporaryFolder desk;
  const DisparityMap map = drawn_map({"123.#x"});
  write_npy(desk / "disparity.npy", (cv::Mat1f(1, 6) << 1.5F, kNaN, 3, 4, 5, kNaN));
  const DisparityMap result = filtered(keep_and_answer(desk, "disparity.npy"), map, false);
  CHECK(result.disparity(0, 0) == 1.5F);
  CHECK(result.at(0, 0) == Status::matched);
  CHECK(result.at(0, 1) == Status::ambiguous);
  CHECK(result.disparity(0, 2) == 3);
  CHECK(result.at(0, 3) == Status::filled);
  CHECK(result.at(0, 4) == Status::masked);
  CHECK(result.at(0, 5) == Status::mismatched);
  CHECK(is_consistent(result));
  const cv::Mat1f given = array_in(desk / "given/map.npy");
  CHECK(given(0, 2) == 3);
  CHECK(std::isnan(given(0, 3)));
  CHECK(array_in(desk / "given/status.npy")(0, 3) == static_cast<int>(Status::occluded));
}

TEST_CASE("the map of the right view is handed over mirrored, with the other sign") {
  const TemporaryFolder desk;
  DisparityMap map({3, 1});
  for (int x = 0; x < 3; ++x) map.set(0, x, static_cast<float>(-x));
  write_npy(desk / "disparity.npy", (cv::Mat1f(1, 3) << 7, 8, 9));
  const DisparityMap result = filtered(keep_and_answer(desk, "disparity.npy"), map, true);
  CHECK(array_in(desk / "given/map.npy")(0, 0) == 2);
  CHECK(result.disparity(0, 0) == -9);
  CHECK(result.disparity(0, 2) == -7);
}

TEST_CASE("disparities that leave the range that is searched are lost, not an error") {
  const TemporaryFolder desk;
  const DisparityMap map = drawn_map({"111"});
  write_npy(desk / "disparity.npy", (cv::Mat1f(1, 3) << 1, 4.5F, -2));
  Context context;
  const ImagePair pair{random_image(map.size(), 1), random_image(map.size(), 2)};
  context.take_view(MatchRequest{pair, DisparityRange::uniform(map.size(), {0, 4}), std::nullopt});
  const DisparityMap result = filtered(keep_and_answer(desk, "disparity.npy"), map, false, context);
  CHECK(result.at(0, 0) == Status::matched);
  CHECK(result.at(0, 1) == Status::out_of_range);
  CHECK(result.at(0, 2) == Status::out_of_range);
}

TEST_CASE("a filter that fails, or writes no map, is one error that names the stage") {
  const TemporaryFolder desk;
  const DisparityMap map = drawn_map({"111"});
  const auto error_with = [&](const std::string& script) {
    return error_of([&] { filtered(command(desk, script), map, false); });
  };
  CHECK(error_with("echo out of ideas; exit 2") ==
        "filter: the program 'sh' failed with exit code 2; it said last: out of ideas");
  CHECK(contains(error_with("exit 0"), "filter: the program wrote neither disparity.npy"));
}
