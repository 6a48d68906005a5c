// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <opencv2/core.hpp>

#include "tests/plugins/maps.hpp"
#include "tests/support/support.hpp"
#include "xgm/plugin.hpp"

using xgm::DisparityMap;
using xgm::Image;
using xgm::ImagePair;
using xgm::Status;
using xgm::testing::identical;

namespace {

struct Settings {
  int radius = 3, iterations = 2;
  double deviation = 0.15, jump = 2;
};

DisparityMap run(const Settings& s, const DisparityMap& map, const ImagePair& pair) {
  const std::string yaml = "{type: least_squares_matching, radius: " + std::to_string(s.radius) +
                           ", iterations: " + std::to_string(s.iterations) +
                           ", deviation: " + std::to_string(s.deviation) +
                           ", jump: " + std::to_string(s.jump) + "}";
  return xgm::testing::stage<xgm::Filter>(yaml)->run(map, pair, xgm::Context{});
}

/// Smooth texture at any place, also between pixels.
double texture(double x, double y) {
  return 128 + 40 * std::sin(0.9 * x + 0.4 * y) + 25 * std::sin(0.35 * x - 0.8 * y + 1) +
         20 * std::sin(1.3 * x + 1.1 * y + 2);
}

/// A plane that faces the camera: base(x) shows what the match image shows at x - disparity.
ImagePair plane(cv::Size size, double disparity, double gain, double offset) {
  ImagePair pair{Image(cv::Mat1f(size)), Image(cv::Mat1f(size))};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      pair.base.planes[0](y, x) = static_cast<float>(texture(x - disparity, y));
      pair.match.planes[0](y, x) = static_cast<float>(gain * texture(x, y) + offset);
    }
  }
  return pair;
}

double grey(const Image& image, int y, int x) {
  if (image.planes.size() == 1) return double{image.planes[0](y, x)};
  return 0.114 * double{image.planes[0](y, x)} + 0.587 * double{image.planes[1](y, x)} +
         0.299 * double{image.planes[2](y, x)};
}

/// Keys' kernel, a = -1/2, and its derivative.
double kernel(double t) {
  const double s = std::abs(t);
  if (s < 1) return 1.5 * s * s * s - 2.5 * s * s + 1;
  return s < 2 ? -0.5 * s * s * s + 2.5 * s * s - 4 * s + 2 : 0;
}
double kernel_slope(double t) {
  const double s = std::abs(t), sign = t < 0 ? -1 : 1;
  if (s < 1) return sign * (4.5 * s * s - 5 * s);
  return s < 2 ? sign * (-1.5 * s * s + 5 * s - 4) : 0;
}

/// One iteration, from the definition: base ~ offset + gain * match - gain * shift * slope over the
/// window, by the normal equations in double.
float oracle(const Settings& s, const DisparityMap& map, const ImagePair& pair, int y, int x) {
  const float before = map.disparity(y, x);
  const auto seen_at = [&](int v, int u) {
    if (map.at(v, u) != Status::matched || !pair.base.is_valid(v, u)) return false;
    const int first = cvFloor(static_cast<float>(u) - map.disparity(v, u)) - 1;
    for (int k = first; k < first + 4; ++k) {
      if (k < 0 || k >= map.size().width || !pair.match.is_valid(v, k)) return false;
    }
    return true;
  };
  if (!seen_at(y, x)) return before;
  std::vector<cv::Vec3d> rows;
  std::vector<double> right;
  for (int v = std::max(0, y - s.radius); v <= std::min(map.size().height - 1, y + s.radius); ++v) {
    for (int u = std::max(0, x - s.radius); u <= std::min(map.size().width - 1, x + s.radius);
         ++u) {
      if (!seen_at(v, u) || !(std::abs(map.disparity(v, u) - before) <= s.jump)) continue;
      const double there = u - double{map.disparity(v, u)};
      double value = 0, slope = 0;
      for (int k = cvFloor(there) - 1; k <= cvFloor(there) + 2; ++k) {
        value += grey(pair.match, v, k) * kernel(there - k);
        slope += grey(pair.match, v, k) * kernel_slope(there - k);
      }
      rows.emplace_back(1, value, slope);
      right.push_back(grey(pair.base, v, u));
    }
  }
  const auto n = static_cast<double>(rows.size());
  if (n <= 6) return before;
  cv::Matx33d normal = cv::Matx33d::zeros();
  cv::Vec3d product;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    normal += rows[i] * rows[i].t();
    product += rows[i] * right[i];
  }
  const cv::Matx33d inverse = normal.inv(cv::DECOMP_SVD);
  const cv::Vec3d found = inverse * product;
  if (found[1] < 0.1) return before;
  double squares = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    squares += std::pow(right[i] - rows[i].dot(found), 2);
  }
  const double variance =
      std::max(squares, n / 12) / (n - 3) * inverse(2, 2) / (found[1] * found[1]);
  const double prior = s.deviation * s.deviation;
  const double shift = prior / (prior + variance) * -found[2] / found[1];
  return static_cast<float>(double{before} + std::clamp(shift, -4 * s.deviation, 4 * s.deviation));
}

}  // namespace

TEST_CASE("least_squares_matching solves the equations of its windows") {
  for (const cv::Size size : xgm::testing::kMapSizes) {
    for (const int planes : {1, 3}) {
      CAPTURE(size);
      ImagePair pair = xgm::testing::random_guide(size, planes, 1);
      pair.match = xgm::testing::random_guide(size, planes, 2).base;
      // Half alike, so that shifts are found.
      for (std::size_t k = 0; k < pair.base.planes.size(); ++k) {
        pair.match.planes[k] = 0.7 * pair.base.planes[k] + 0.3 * pair.match.planes[k];
      }
      pair.base.valid = xgm::testing::random_mask(size, 0.05, 3);
      const DisparityMap map = xgm::testing::random_map(size, {-1, 1, 0.25, 0.1}, 4);
      for (const Settings& s : {Settings{2, 1, 0.2, 2}, Settings{4, 1, 1, 0.5}}) {
        const DisparityMap result = run(s, map, pair);
        CHECK(cv::norm(result.status, map.status, cv::NORM_INF) == 0);
        for (int y = 0; y < size.height; ++y) {
          for (int x = 0; x < size.width; ++x) {
            if (!map.has_disparity(y, x)) continue;
            CHECK(result.disparity(y, x) ==
                  doctest::Approx(double{oracle(s, map, pair, y, x)}).epsilon(2e-3).scale(1));
          }
        }
      }
    }
  }
}

TEST_CASE("least_squares_matching undoes the pull to whole disparities, whatever the light") {
  const cv::Size size(60, 40);
  for (const double disparity : {-3.7, -0.25, 0.0, 2.1, 5.5, 6.9}) {
    for (const double gain : {1.0, 0.6}) {
      const ImagePair pair = plane(size, disparity, gain, 20);
      const double fraction = disparity - std::round(disparity);
      const double locked = std::round(disparity) + fraction / 2;
      DisparityMap map(size);
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) map.set(y, x, static_cast<float>(locked));
      }
      const DisparityMap result = run({}, map, pair);
      const cv::Mat1f inside = result.disparity.colRange(10, size.width - 10);
      // What is left is what a cubic polynomial misses of waves that are 5 px long.
      CHECK(cv::norm(inside - disparity, cv::NORM_INF) < 0.03);
    }
  }
}

TEST_CASE("least_squares_matching leaves alone what it knows nothing of") {
  const cv::Size size(30, 20);
  const DisparityMap map = xgm::testing::random_map(size, {0, 6, 0.5, 0.3}, 1);
  const ImagePair flat{Image(cv::Mat1f(size, 100.0F)), Image(cv::Mat1f(size, 100.0F))};
  CHECK(identical(run({}, map, flat), map));
  const ImagePair pair = xgm::testing::random_guide(size, 1, 1);
  const DisparityMap result = run({}, map, pair);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (map.at(y, x) == Status::filled) CHECK(result.disparity(y, x) == map.disparity(y, x));
      if (map.at(y, x) != Status::matched) continue;
      CHECK(std::abs(result.disparity(y, x) - map.disparity(y, x)) <= 0.6001);
    }
  }
}
