// SPDX-License-Identifier: Apache-2.0
// Generated scenes are reproducible, of any size, and wrong options are refused.
#include <string>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/synthesis/generate.hpp"

using namespace xgm;
using namespace xgm::synthesis;
using xgm::testing::contains;
using xgm::testing::error_of;

namespace {

std::uint64_t hash(const GeneratedScene& scene) {
  std::string bytes;
  const auto add = [&](const cv::Mat& map) {
    for (int y = 0; y < map.rows; ++y)
      bytes.append(map.ptr<char>(y), static_cast<std::size_t>(map.cols) * map.elemSize());
  };
  for (const Image* image : {&scene.pair.base, &scene.pair.match})
    for (const cv::Mat1f& plane : image->planes) add(plane);
  for (const cv::Mat& map : std::initializer_list<cv::Mat>{
           scene.truth, scene.reverse_truth, scene.non_occluded, scene.reverse_non_occluded})
    add(map);
  return fnv1a64(bytes);
}

Options with_all_faults(std::uint64_t seed) {
  Options options;
  options.size = {161, 97};
  options.disparities = {-8, 30};
  options.seed = seed;
  for (const FaultKind& kind : fault_kinds()) plant(options.faults, kind.name);
  return options;
}

}  // namespace

TEST_CASE("synthesis: the same options give the same bytes for any number of threads") {
  // Golden: what this test prints when the generator is changed on purpose.
  constexpr std::uint64_t kGolden = 7398577305321064330u;
  for (const int count : {1, 2, 3, 8}) {
    const ThreadLimit threads(count);
    CHECK(hash(generate(with_all_faults(5))) == kGolden);
  }
  CHECK(hash(generate(with_all_faults(6))) != kGolden);
}

TEST_CASE("synthesis: every size will do, with every fault") {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 40), cv::Size(40, 1), cv::Size(2, 3),
                              cv::Size(33, 35), cv::Size(700, 3)}) {
    for (const Interval interval : {Interval{0, 64}, Interval{-5, -4}}) {
      Options options = with_all_faults(3);
      options.size = size;
      options.disparities = interval;
      const GeneratedScene scene = generate(options);
      CHECK(scene.truth.size() == size);
      CHECK(cv::checkRange(scene.truth));
      CHECK(cv::checkRange(scene.reverse_truth));
      for (const cv::Mat1f& plane : scene.pair.match.planes)
        CHECK(cv::checkRange(plane, true, nullptr, 0, 255.001));
    }
  }
}

TEST_CASE("synthesis: 16 bits are steps of 1/257, grey is one plane, 0 bits are not rounded") {
  Options options;
  options.size = {60, 40};
  options.bits = 16;
  options.colour = false;
  const GeneratedScene fine = generate(options);
  REQUIRE(fine.pair.base.planes.size() == 1);
  int beside_whole = 0;
  for (const float level : fine.pair.base.planes[0]) {
    const double steps = static_cast<double>(level) * 257;
    CHECK(std::abs(steps - std::round(steps)) < 5e-3);
    if (std::abs(level - std::round(level)) > 0.01F) ++beside_whole;
  }
  CHECK(beside_whole > 2000);
  options.bits = 0;
  CHECK(cv::norm(generate(options).pair.base.planes[0], fine.pair.base.planes[0], cv::NORM_INF) <
        0.002);
}

TEST_CASE("synthesis: options out of range are refused with what they may be") {
  const auto refusal = [](auto change) {
    Options options;
    options.size = {4, 4};
    change(options);
    return error_of([&] { generate(options); });
  };
  CHECK(refusal([](Options&) {}) == "");
  CHECK(contains(refusal([](Options& o) { o.size = {0, 4}; }), "at least 1 x 1"));
  CHECK(contains(refusal([](Options& o) { o.disparities = {3, 3}; }), "disparities"));
  CHECK(contains(refusal([](Options& o) { o.disparities = {0, 2'000'000}; }), "million"));
  CHECK(contains(refusal([](Options& o) { o.objects = -1; }), "0 to 1000"));
  CHECK(contains(refusal([](Options& o) { o.bits = 12; }), "8 or 16"));
  CHECK(contains(refusal([](Options& o) { o.samples = 0; }), "1 to 16"));
  CHECK(contains(refusal([](Options& o) { o.lens = -1; }), "lens"));
  CHECK(contains(refusal([](Options& o) { o.faults.vertical.b = -1; }), "b > -1"));
  CHECK(contains(refusal([](Options& o) { o.faults.noise = std::nan(""); }), "0 to 255"));
}
