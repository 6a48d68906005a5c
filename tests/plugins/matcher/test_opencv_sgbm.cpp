// SPDX-License-Identifier: Apache-2.0
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "plugins/matcher/fakes.hpp"

namespace xgm::testing::matchers {
namespace {

/// A textured pair whose disparity is `left` in the left and `right` in the right half.
ImagePair two_planes(cv::Size size, int left, int right, int channels) {
  ImagePair pair = random_pair(size, 3, channels);
  for (std::size_t c = 0; c < pair.base.planes.size(); ++c) {
    cv::Mat1f& base = pair.base.planes[c];
    cv::GaussianBlur(base, base, {3, 3}, 0);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const int seen = x - (x < size.width / 2 ? left : right);
        if (0 <= seen && seen < size.width) pair.match.planes[c](y, seen) = base(y, x);
      }
    }
  }
  return pair;
}

cv::Mat plain_8bit(const Image& image) {
  cv::Mat merged, bytes;
  cv::merge(image.planes, merged);
  merged.convertTo(bytes, CV_8U);
  return bytes;
}

cv::Mat widened(const cv::Mat& image, int left, int right) {
  cv::Mat wide;
  cv::copyMakeBorder(image, wide, 0, 0, left, right, cv::BORDER_REPLICATE);
  return wide;
}

struct Setting {
  const char* name;
  int mode;
};
const Setting kModes[] = {{"sgbm", cv::StereoSGBM::MODE_SGBM},
                          {"hh", cv::StereoSGBM::MODE_HH},
                          {"sgbm_3way", cv::StereoSGBM::MODE_SGBM_3WAY},
                          {"hh4", cv::StereoSGBM::MODE_HH4}};

std::string yaml_of(const Setting& setting, bool pad) {
  return std::string("{type: opencv_sgbm, mode: ") + setting.name +
         ", block_size: 3, p1: 216, p2: 864, uniqueness_ratio: 10, speckle_window_size: 20, "
         "speckle_range: 2, disp12_max_diff: 1, pre_filter_cap: 31, pad: " +
         (pad ? "true" : "false") + "}";
}

/// What cv::StereoSGBM itself says, with the same border. `interval` is a multiple of 16 long.
cv::Mat1s direct(const Setting& setting, const ImagePair& pair, Interval interval, bool pad) {
  const int left = pad ? std::max(interval.end, 0) : 0;
  const int right = pad ? std::max(-interval.begin, 0) : 0;
  const auto matcher = cv::StereoSGBM::create(interval.begin, interval.size(), 3, 216, 864, 1, 31,
                                              10, 20, 2, setting.mode);
  cv::Mat1s sixteenths;
  matcher->compute(widened(plain_8bit(pair.base), left, right),
                   widened(plain_8bit(pair.match), left, right), sixteenths);
  return sixteenths.colRange(left, left + pair.size().width);
}

TEST_CASE("opencv_sgbm equals cv::StereoSGBM called directly, in every mode") {
  const cv::Size size(121, 43);
  for (const Setting& setting : kModes) {
    for (const int channels : {1, 3}) {
      for (const bool pad : {true, false}) {
        for (const Interval interval : {Interval{0, 16}, {-9, 7}, {-32, -16}, {3, 35}}) {
          INFO(setting.name, ", channels ", channels, ", pad ", pad, ", from ", interval.begin);
          const int middle = (interval.begin + interval.end) / 2;
          const ImagePair pair = two_planes(size, middle - 3, middle + 2, channels);
          const auto map = stage<Matcher>(yaml_of(setting, pad))
                               ->run({pair, DisparityRange::uniform(size, interval), {}}, Context{})
                               .forward;
          const cv::Mat1s expected = direct(setting, pair, interval, pad);
          int wrong = 0;
          for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
              const float d = static_cast<float>(expected(y, x)) / 16;
              const int seen = static_cast<int>(std::lround(static_cast<float>(x) - d));
              const bool valid =
                  d >= static_cast<float>(interval.begin) && seen >= 0 && seen < size.width;
              wrong += map.has_disparity(y, x) != valid;
              if (valid && map.has_disparity(y, x)) wrong += map.disparity(y, x) != d;
            }
          }
          CHECK(wrong == 0);
          CHECK(map.density() > 0.4);  // else this proves little
        }
      }
    }
  }
}

TEST_CASE("disparities beyond the asked range are out_of_range, though OpenCV searched them") {
  const cv::Size size(100, 30);
  const ImagePair pair = two_planes(size, 4, 11, 1);
  const auto map = stage<Matcher>("opencv_sgbm")
                       ->run({pair, DisparityRange::uniform(size, {0, 7}), {}}, Context{})
                       .forward;
  CHECK(map.disparity(15, 30) == doctest::Approx(4));
  CHECK(map.at(15, 80) == Status::out_of_range);
}

TEST_CASE("padding makes the columns at the border matchable") {
  const cv::Size size(100, 30);
  const ImagePair pair = two_planes(size, 4, 4, 1);
  const MatchRequest request{pair, DisparityRange::uniform(size, {0, 32}), {}};
  const auto padded = stage<Matcher>("opencv_sgbm")->run(request, Context{}).forward;
  const auto plain = stage<Matcher>("{type: opencv_sgbm, pad: false}")->run(request, {}).forward;
  CHECK(padded.disparity(15, 12) == doctest::Approx(4));
  CHECK(plain.at(15, 12) == Status::out_of_range);
  CHECK(padded.at(15, 1) != Status::matched);  // seen outside the match image
}

TEST_CASE("masked base pixels end as masked and masked match pixels match nothing") {
  const cv::Size size(90, 30);
  ImagePair pair = two_planes(size, 4, 4, 3);
  pair.base.valid = cv::Mat1b(size, std::uint8_t{255});
  pair.match.valid = cv::Mat1b(size, std::uint8_t{255});
  pair.base.valid(cv::Rect(50, 10, 9, 5)).setTo(0);
  pair.match.valid(cv::Rect(20, 10, 9, 5)).setTo(0);
  pair.base.planes[1](12, 52) = std::numeric_limits<float>::quiet_NaN();
  const auto map = stage<Matcher>("opencv_sgbm")
                       ->run({pair, DisparityRange::uniform(size, {0, 16}), {}}, Context{})
                       .forward;
  for (int y = 10; y < 15; ++y) {
    for (int x = 0; x < size.width; ++x) {
      CHECK((map.at(y, x) == Status::masked) == (x >= 50 && x < 59));
      if (!map.has_disparity(y, x)) continue;
      const auto seen = std::lround(static_cast<float>(x) - map.disparity(y, x));
      CHECK((seen < 20 || seen >= 29));
    }
  }
  CHECK(map.density() > 0.6);
}

TEST_CASE("opencv_sgbm takes tiny images, wide ranges and empty ones in every mode") {
  for (const Setting& setting : kModes) {
    for (const bool pad : {true, false}) {
      for (const cv::Size size : {cv::Size(1, 1), {3, 1}, {1, 5}, {17, 4}}) {
        for (const Interval interval : {Interval{0, 1}, {-40, 200}, {-3, 0}, {30, 40}, {0, 0}}) {
          const auto map =
              stage<Matcher>(yaml_of(setting, pad))
                  ->run({random_pair(size, 2), DisparityRange::uniform(size, interval), {}}, {})
                  .forward;
          CHECK(map.size() == size);
        }
      }
    }
  }
}

TEST_CASE("opencv_sgbm does not depend on the number of OpenCV's threads") {
  const cv::Size size(160, 90);
  const MatchRequest request{
      two_planes(size, 4, 12, 3), DisparityRange::uniform(size, {0, 32}), {}};
  const int before = cv::getNumThreads();
  for (const Setting& setting : kModes) {
    const auto matcher = stage<Matcher>(yaml_of(setting, true));
    cv::setNumThreads(1);
    const auto one = matcher->run(request, Context{}).forward;
    cv::setNumThreads(3);
    CHECK(identical(matcher->run(request, Context{}).forward, one));
  }
  cv::setNumThreads(before);
}

TEST_CASE("opencv_sgbm refuses to look for speckles in images beyond 16 bits, and matches them") {
  const auto searching = stage<Matcher>("{type: opencv_sgbm, speckle_window_size: 100}");
  const auto matching = stage<Matcher>("opencv_sgbm");
  for (const cv::Size size : {cv::Size(40000, 4), cv::Size(4, 40000)}) {
    const MatchRequest request{random_pair(size, 1), DisparityRange::uniform(size, {0, 3}), {}};
    CHECK_THROWS_WITH_AS(searching->run(request, {}),
                         doctest::Contains("up to 32767 px to a side, but these have"), Error);
    CHECK(matching->run(request, {}).forward.size() == size);
  }
}

TEST_CASE("opencv_sgbm refuses range maps, disparities beyond 16 bits and p2 below p1") {
  const cv::Size size(20, 10);
  const auto matcher = stage<Matcher>("opencv_sgbm");
  CHECK_FALSE(matcher->accepts_range_maps());
  CHECK_THROWS_AS(matcher->run({random_pair(size, 1), random_range(size, {0, 9}, 2), {}}, {}),
                  Error);
  CHECK_THROWS_AS(
      matcher->run({random_pair(size, 1), DisparityRange::uniform(size, {2000, 2040}), {}}, {}),
      Error);
  CHECK_THROWS_WITH_AS(stage<Matcher>("{type: opencv_sgbm, p1: 9, p2: 8}"),
                       doctest::Contains("must be larger than p1"), Error);
}

}  // namespace
}  // namespace xgm::testing::matchers
