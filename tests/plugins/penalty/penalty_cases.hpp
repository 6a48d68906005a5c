// SPDX-License-Identifier: Apache-2.0
// What every penalty is tested on: all sixteen directions, and the comparison with an oracle.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "support/support.hpp"

namespace xgm::testing {

inline const std::vector<Direction> kDirections{
    {1, 0}, {-1, 0}, {0, 1},  {0, -1},  {1, 1}, {-1, 1}, {1, -1}, {-1, -1},
    {2, 1}, {-2, 1}, {2, -1}, {-2, -1}, {1, 2}, {-1, 2}, {1, -2}, {-1, -2}};

/// P1 and P2 of base pixel (y, x) at disparity d on the path with step r, from the formula.
using PenaltyOracle =
    std::function<PenaltyPair(const ImagePair&, Direction r, int y, int x, int d)>;

/// |I(p) - I(p - r)| of a view's grey image, to the precision of grey levels; 0 where one of the
/// two does not exist.
inline double change(const Image& view, Direction r, int y, int x) {
  const cv::Rect image({0, 0}, view.size());
  const cv::Point p(x, y), q(x - r.dx, y - r.dy);
  if (!image.contains(p) || !image.contains(q)) return 0;
  if (!view.is_valid(p.y, p.x) || !view.is_valid(q.y, q.x)) return 0;
  const cv::Mat1f grey = view.grey();
  return std::abs(static_cast<double>(grey(p) - grey(q)));
}

/// Grey levels that are far apart, near each other, and equal to the thresholds in use.
inline Image stepped_image(cv::Size size, std::uint64_t seed, int channels, bool masked) {
  Image image = random_image(size, seed, channels);
  for (cv::Mat1f& plane : image.planes) {
    for (float& value : plane) value = 10.0F * std::floor(value / 40.0F);
  }
  if (!masked) return image;
  image.valid = random_mask(size, 0.2, seed + 1);
  for (cv::Mat1f& plane : image.planes) {
    plane.setTo(std::numeric_limits<float>::quiet_NaN(), image.valid == 0);
  }
  return image;
}

inline std::vector<ImagePair> penalty_pairs() {
  std::vector<ImagePair> pairs;
  for (const cv::Size size :
       {cv::Size(1, 1), cv::Size(9, 1), cv::Size(1, 9), cv::Size(2, 2), cv::Size(33, 17)}) {
    for (const int channels : {1, 3}) {
      for (const bool masked : {false, true}) {
        pairs.push_back(
            {stepped_image(size, 1, channels, masked), stepped_image(size, 2, channels, masked)});
      }
    }
  }
  return pairs;
}

/// Describes the first wrong penalty; empty if none is.
inline std::string first_fault(const Penalty& penalty, const PenaltyOracle& oracle,
                               const ImagePair& pair) {
  const auto field = penalty.run(pair, Context{});
  const int width = pair.size().width;
  std::vector<std::uint8_t> base(static_cast<std::size_t>(width)), match(base.size());
  std::ostringstream fault;
  for (const Direction r : kDirections) {
    const PenaltyTable table = field->table(r);
    const auto entries = static_cast<std::size_t>(table.base_classes * table.match_classes);
    if (table.entries.size() != entries) return "the table's size is wrong";
    for (int y = 0; y < pair.size().height; ++y) {
      std::fill(base.begin(), base.end(), std::uint8_t{255});
      std::fill(match.begin(), match.end(), std::uint8_t{255});
      field->classify(r, y, base, match);
      for (int i = 0; i < width * width; ++i) {
        const int x = i / width, other = i % width;
        const int base_class = base[static_cast<std::size_t>(x)];
        const int match_class = match[static_cast<std::size_t>(other)];
        if (base_class >= table.base_classes || match_class >= table.match_classes) {
          return "a class is out of range";
        }
        const cv::Point q(x - r.dx, y - r.dy);
        if (!cv::Rect({0, 0}, pair.size()).contains(q) || !pair.base.is_valid(y, x)) continue;
        const PenaltyPair pair_of = table.at(base_class, match_class);
        const PenaltyPair expected = oracle(pair, r, y, x, x - other);
        if (pair_of == expected && pair_of.p1 >= 0 && pair_of.p1 <= pair_of.p2) continue;
        fault << pair.size() << " at (" << x << ", " << y << "; " << x - other << ") along ("
              << r.dx << ", " << r.dy << "): " << pair_of.p1 << ", " << pair_of.p2 << ", not "
              << expected.p1 << ", " << expected.p2;
        return fault.str();
      }
    }
  }
  return {};
}

inline void check_penalties(const std::string& yaml, const PenaltyOracle& oracle) {
  const auto penalty = stage<Penalty>(yaml);
  for (const ImagePair& pair : penalty_pairs()) CHECK(first_fault(*penalty, oracle, pair) == "");
}

}  // namespace xgm::testing
