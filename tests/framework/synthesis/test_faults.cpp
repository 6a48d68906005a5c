// SPDX-License-Identifier: Apache-2.0
// Each planted fault does what it says, and nothing else.
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/synthesis/generate.hpp"

using namespace xgm;
using namespace xgm::synthesis;
using xgm::testing::contains;
using xgm::testing::error_of;

namespace {

/// Unrounded, without noise, one plane: what differs is the fault.
GeneratedScene scene_with(const std::string& fault, Options options = {}) {
  if (options.content == Content::rich) options.size = {200, 150};
  options.disparities = {0, 24};
  options.colour = false;
  options.bits = 0;
  options.sensor_noise = 0;
  if (!fault.empty()) plant(options.faults, fault);
  return generate(options);
}

const cv::Mat1f& base(const GeneratedScene& scene) { return scene.pair.base.planes[0]; }
const cv::Mat1f& match(const GeneratedScene& scene) { return scene.pair.match.planes[0]; }

double farthest(const cv::Mat1f& a, const cv::Mat1f& b) { return cv::norm(a, b, cv::NORM_INF); }

template <class Function>
cv::Mat1f mapped(const cv::Mat1f& image, Function function) {
  cv::Mat1f result = image.clone();
  for (float& level : result) level = static_cast<float>(function(static_cast<double>(level)));
  return result;
}

}  // namespace

TEST_CASE("fault exposure: the match view times a factor, plus a bias, clipped") {
  const GeneratedScene clean = scene_with(""), faulty = scene_with("exposure=1.7,-20");
  CHECK(farthest(base(clean), base(faulty)) == 0);
  const cv::Mat1f expected =
      mapped(match(clean), [](double v) { return std::clamp(1.7 * v - 20, 0.0, 255.0); });
  CHECK(farthest(expected, match(faulty)) < 1e-3);
}

TEST_CASE("fault gamma: the match view to a power") {
  const GeneratedScene clean = scene_with(""), faulty = scene_with("gamma=2.2");
  CHECK(farthest(base(clean), base(faulty)) == 0);
  const cv::Mat1f expected =
      mapped(match(clean), [](double v) { return 255 * std::pow(v / 255, 2.2); });
  CHECK(farthest(expected, match(faulty)) < 1e-3);
}

TEST_CASE("fault noise: of the deviation asked for, in both views, not the same") {
  const GeneratedScene clean = scene_with(""), faulty = scene_with("noise=6");
  const cv::Mat1f in_base(base(faulty) - base(clean)), in_match(match(faulty) - match(clean));
  for (const cv::Mat1f& noise : {in_base, in_match}) {
    cv::Scalar mean, deviation;
    cv::meanStdDev(noise, mean, deviation);
    CHECK(std::abs(mean[0]) < 0.2);
    CHECK(std::abs(deviation[0] - 6) < 0.2);
  }
  CHECK(std::abs(cv::mean(in_base.mul(in_match))[0]) < 1);
}

TEST_CASE("fault blur: the match view behind a Gaussian") {
  const GeneratedScene clean = scene_with(""), faulty = scene_with("blur=1.5");
  CHECK(farthest(base(clean), base(faulty)) == 0);
  cv::Mat1f expected;
  cv::GaussianBlur(match(clean), expected, {}, 1.5);
  const cv::Rect inner(8, 8, 184, 134);  // beyond the border the world goes on
  CHECK(farthest(expected(inner), match(faulty)(inner)) < 2.5);
  CHECK(farthest(match(clean)(inner), match(faulty)(inner)) > 20);
}

TEST_CASE("fault vignetting: both views, nothing in the middle, all of it in the corners") {
  const GeneratedScene clean = scene_with(""), faulty = scene_with("vignetting=0.6");
  for (const auto& views : {std::pair{base(clean), base(faulty)}, {match(clean), match(faulty)}}) {
    const auto left = [&](int y, int x) {
      return static_cast<double>(views.second(y, x) / views.first(y, x));
    };
    CHECK(left(0, 0) == doctest::Approx(0.4).epsilon(1e-4));
    CHECK(left(149, 199) == doctest::Approx(0.4).epsilon(1e-4));
    CHECK(left(75, 100) == doctest::Approx(1).epsilon(1e-3));
  }
}

TEST_CASE("fault shadow: parts of the match view, as dark as asked for, with soft edges") {
  const GeneratedScene clean = scene_with(""), faulty = scene_with("shadow=0.7");
  CHECK(farthest(base(clean), base(faulty)) == 0);
  int lit = 0, dark = 0, between = 0;
  for (int y = 0; y < 150; ++y) {
    for (int x = 0; x < 200; ++x) {
      const double left = static_cast<double>(match(faulty)(y, x) / match(clean)(y, x));
      CHECK(left > 0.299);
      CHECK(left < 1.001);
      ++(left > 0.999 ? lit : left < 0.301 ? dark : between);
    }
  }
  CHECK(lit > 6000);
  CHECK(dark > 3000);
  CHECK(between > 1000);
}

TEST_CASE("fault highlight: light is added in both views, at other places of the scene") {
  const GeneratedScene clean = scene_with(""), faulty = scene_with("highlight=1");
  const cv::Mat1f in_base(base(faulty) - base(clean)), in_match(match(faulty) - match(clean));
  double sum = 0, apart = 0;
  for (int y = 0; y < 150; ++y) {
    for (int x = 0; x < 200; ++x) {
      CHECK(in_base(y, x) >= 0);
      CHECK(in_match(y, x) >= 0);
      const int x_match = x - static_cast<int>(std::lround(clean.truth(y, x)));
      if (clean.non_occluded(y, x) == 0 || x_match < 0) continue;
      sum += static_cast<double>(in_base(y, x));
      apart += static_cast<double>(std::abs(in_base(y, x) - in_match(y, x_match)));
    }
  }
  CHECK(sum > 200 * 150);
  CHECK(apart > 0.5 * sum);
}

TEST_CASE("fault weak_texture: that much less contrast, in about that share of the scene") {
  Options plain;
  plain.content = Content::plain;
  plain.size = {600, 400};
  plain.objects = 0;
  plain.lens = 0;
  plain.samples = 1;
  const GeneratedScene clean = scene_with("", plain);
  CHECK(farthest(base(clean), base(scene_with("weak_texture=0.9,0", plain))) == 0);
  const auto slope = [](const cv::Mat1f& image, int y, int x) {
    return static_cast<double>(image(y, x + 1) - image(y, x));
  };
  struct Expected {
    std::string fault;
    double low, high;
  };
  for (const Expected& expected : {Expected{"weak_texture=0.9,1", 1, 1},
                                   {"weak_texture=0.9,0.5", 0.35, 0.65},
                                   {"weak_texture=0.9,0.2", 0.05, 0.35}}) {
    const GeneratedScene faulty = scene_with(expected.fault, plain);
    int steep = 0, weak = 0;
    for (int y = 0; y < 400; ++y) {
      for (int x = 0; x < 599; ++x) {
        const double before = slope(base(clean), y, x), after = slope(base(faulty), y, x);
        if (std::abs(before) < 5) continue;
        ++steep;
        if (std::abs(after - 0.1 * before) < 0.01) ++weak;
      }
    }
    CAPTURE(expected.fault);
    CHECK(steep > 10000);
    CHECK(weak >= expected.low * steep);
    CHECK(weak <= expected.high * steep);
  }
}

TEST_CASE("fault repetitive: the same again after each period") {
  Options plain;
  plain.content = Content::plain;
  plain.objects = 0;
  const GeneratedScene faulty = scene_with("repetitive=1,12", plain);
  CHECK(farthest(base(faulty).colRange(0, 628), base(faulty).colRange(12, 640)) < 0.01);
  CHECK(farthest(base(faulty).colRange(0, 634), base(faulty).colRange(6, 640)) > 50);
}

TEST_CASE("fault vertical: rows of the match view are found where the shift says") {
  const GeneratedScene clean = scene_with(""), faulty = scene_with("vertical=0,0,3");
  CHECK(farthest(base(clean), base(faulty)) == 0);
  CHECK(farthest(match(clean).rowRange(0, 147), match(faulty).rowRange(3, 150)) < 1e-3);
  CHECK(farthest(clean.reverse_truth.rowRange(0, 147), faulty.reverse_truth.rowRange(3, 150)) <
        1e-4);
}

TEST_CASE("faults are planted by name, with as many values as there are") {
  Faults faults;
  plant(faults, "exposure=1.3");
  plant(faults, "vertical=0.001,0.02,-4");
  plant(faults, "blur");
  CHECK(faults.exposure == 1.3);
  CHECK(faults.bias == 0);
  CHECK(faults.vertical.b == 0.02);
  CHECK(faults.vertical.c == -4);
  CHECK(faults.blur == 2);
  CHECK(faults.noise == 0);
  const auto refusal = [](const char* fault) {
    return error_of([&] {
      Faults any;
      plant(any, fault);
    });
  };
  CHECK(contains(refusal("blurr=2"), "did you mean 'blur'?"));
  CHECK(contains(refusal("=2"), "there are: weak_texture, "));
  CHECK(contains(refusal("blur=much"), "is 'much'; give a number, as in blur=2"));
  CHECK(contains(refusal("blur="), "give a number"));
  CHECK(contains(refusal("blur=1,2"), "1 values at most"));
  CHECK(contains(refusal("blur=-1"), "is -1; give a number from 0 to 50 (px)"));
  CHECK(contains(refusal("noise=nan"), "give a number from 0 to 255"));
}

TEST_CASE("every fault has a sentence, and a strength within its range that is not harmless") {
  for (const FaultKind& kind : fault_kinds()) {
    CAPTURE(kind.name);
    CHECK(kind.text.ends_with('.'));
    Faults harmless, planted;
    plant(planted, kind.name);
    bool differs = false;
    for (const FaultValue& value : kind.values)
      differs = differs || value.in(harmless) != value.in(planted);
    CHECK(differs);
  }
}
