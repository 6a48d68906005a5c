// SPDX-License-Identifier: Apache-2.0
// Cost functions that are programs of others.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "external/programs.hpp"
#include "xgm/stage/slot.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

const cv::Size kSize(6, 4);

VolumeShapePtr shape(Interval range) {
  return std::make_shared<const VolumeShape>(DisparityRange::uniform(kSize, range));
}

ImagePair pair() { return {random_image(kSize, 1), random_image(kSize, 2)}; }

/// uint8 numbers of the shape (4, 6, depth), of which cell (y, x, i) is value(y, x, i).
template <class Value>
void write_bytes(const std::string& file, int depth, const Value& value) {
  cv::Mat numbers(kSize, CV_MAKETYPE(CV_8U, depth));
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      for (int i = 0; i < depth; ++i) {
        numbers.ptr(y)[x * depth + i] = static_cast<std::uint8_t>(value(y, x, i));
      }
    }
  }
  write_npy(file, numbers);
}

CostVolume costs(const std::string& parameters, const ImagePair& images, Interval range) {
  const Slot<Cost> slot(stage<Cost>("{type: external, " + parameters + "}"));
  return slot(Context(), images, shape(range));
}

std::string error_with(const std::string& parameters) {
  return error_of([&] { costs(parameters, pair(), {-1, 2}); });
}

}  // namespace

TEST_CASE("an external cost is what its program wrote, where the candidate can be seen") {
  const TemporaryFolder desk;
  const auto value = [](int y, int x, int i) { return 40 * y + 6 * x + i; };
  write_bytes(desk / "cost.npy", 3, value);
  const CostVolume volume = costs(keep_and_answer(desk, "cost.npy"), pair(), {-1, 2});
  CHECK(volume.max_cost == 254);
  CHECK(request_in(desk).at("kind").text() == "cost");
  CHECK(request_in(desk).at("disparities").dump() == "[-1,1]");
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      for (int i = 0; i < 3; ++i) {
        const int seen = x - (i - 1);
        const int expected = seen < 0 || seen >= kSize.width ? 255 : value(y, x, i);
        CHECK(volume.at(y, x)[i] == expected);
      }
    }
  }
}

TEST_CASE("costs of the right view are turned back") {
  const TemporaryFolder desk;
  const auto value = [](int y, int x, int i) { return 40 * y + 6 * x + i; };
  write_bytes(desk / "cost.npy", 3, value);
  const CostVolume volume = costs(keep_and_answer(desk, "cost.npy"), pair().swapped(), {-2, 1});
  CHECK(request_in(desk).at("disparities").dump() == "[0,2]");
  for (int d = -2; d <= 0; ++d) {
    CHECK(volume.at(1, 2)[d + 2] == value(1, kSize.width - 1 - 2, -d));
  }
}

TEST_CASE("numbers become costs by their scale; what is not known is as unlike as can be") {
  const TemporaryFolder desk;
  cv::Mat numbers(kSize, CV_32FC3, cv::Scalar(0.5, 0.126, 9));
  numbers.ptr<float>(2)[3 * 3] = std::numeric_limits<float>::quiet_NaN();
  write_npy(desk / "cost.npy", numbers);
  const CostVolume volume =
      costs(keep_and_answer(desk, "cost.npy") + ", scale: 100, max_cost: 200", pair(), {-1, 2});
  CHECK(volume.max_cost == 200);
  CHECK(volume.at(1, 3)[0] == 50);
  CHECK(volume.at(1, 3)[1] == 13);
  CHECK(volume.at(1, 3)[2] == 200);
  CHECK(volume.at(2, 3)[0] == 200);
}

TEST_CASE("each fault of a program that computes costs is one error") {
  const TemporaryFolder desk;
  write_bytes(desk / "few.npy", 2, [](int, int, int) { return 1; });
  write_npy(desk / "flat.npy", cv::Mat1b(kSize, std::uint8_t{1}));
  cv::Mat negative(kSize, CV_32FC3, cv::Scalar::all(1));
  negative.ptr<float>(1)[2 * 3 + 1] = -0.5F;
  write_npy(desk / "negative.npy", negative);
  const auto check = [&](const std::string& name, const std::string& what) {
    const std::string error =
        error_with(command(desk, "cp '" + (desk / name) + "' \"$folder/cost.npy\""));
    INFO(error);
    CHECK(error.starts_with("cost: "));
    CHECK(contains(error, what));
  };
  check("few.npy", "has the disparities -1 to 0, and -1 to 1 are searched");
  check("flat.npy", "has the shape (4, 6), and (4, 6, disparities) is wanted");
  check("negative.npy", "holds a negative cost (x 2, y 1, disparity 0)");
  CHECK(contains(error_with(command(desk, "exit 0")), "wrote no cost.npy"));
}

TEST_CASE("external costs are aggregated like any other") {
  const ImagePair images = shifted_pair({40, 30}, 3, 8);
  const auto matcher = stage<Matcher>("{type: semi_global, cost: {type: external, " +
                                      honest("cost") + "}, penalty: constant, aggregation: sgm}");
  const DisparityMap map =
      matcher->run({images, DisparityRange::uniform({40, 30}, {0, 8}), std::nullopt}, {}).forward;
  CHECK(map.disparity(15, 20) == 3);
}
