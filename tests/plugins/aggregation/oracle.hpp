// SPDX-License-Identifier: Apache-2.0
// The paper's Eq. 3, 4 and 6 in double, plainly: one recursive function, no normalisation.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "support/support.hpp"

namespace xgm::testing {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Values of all cells in the order of a volume.
using Sums = std::vector<double>;

inline std::vector<Direction> all_directions(int count) {
  std::vector<Direction> r{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  if (count >= 8) r.insert(r.end(), {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}});
  if (count >= 16)
    for (const int a : {-1, 1})
      for (const int b : {-1, 1}) r.insert(r.end(), {{a, 2 * b}, {2 * a, b}});
  return r;
}

class Oracle {
 public:
  enum class Method { sgm, mgm };

  Oracle(const CostVolume& costs, const PenaltyField& penalties, Method method)
      : costs_(costs), shape_(costs.shape()), penalties_(penalties), method_(method) {}

  /// Eq. 4, less (N - 1) C if `corrected`.
  Sums sums(int directions, bool corrected) {
    Sums sums(static_cast<std::size_t>(shape_.cells()), kInfinite);  // behind a slice, too
    for (int y = 0; y < shape_.height(); ++y)
      for (int x = 0; x < shape_.width(); ++x)
        std::fill_n(sums.begin() + shape_.offset(y, x), shape_.count(y, x), 0.0);
    for (const Direction r : all_directions(directions)) {
      start(r);
      for (int y = 0; y < shape_.height(); ++y)
        for (int x = 0; x < shape_.width(); ++x) {
          const std::vector<double>& l = path_cost({x, y});
          for (std::size_t i = 0; i < l.size(); ++i) sums[cell(x, y) + i] += l[i];
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (corrected && sums[i] < kInfinite) sums[i] -= (directions - 1) * double(costs_.data()[i]);
    return sums;
  }

 private:
  std::size_t cell(int x, int y) const { return static_cast<std::size_t>(shape_.offset(y, x)); }

  void start(Direction r) {
    known_.assign(static_cast<std::size_t>(shape_.width() * shape_.height()), std::nullopt);
    steps_ = {r};
    if (method_ == Method::mgm) steps_.push_back({r.dy, -r.dx});
    tables_.clear();
    classes_.clear();
    for (const Direction x : steps_) {
      tables_.push_back(penalties_.table(x));
      auto& rows = classes_.emplace_back(static_cast<std::size_t>(shape_.height()));
      for (int y = 0; y < shape_.height(); ++y) {
        Row& row = rows[static_cast<std::size_t>(y)];
        row.base.resize(static_cast<std::size_t>(shape_.width()));
        row.match = row.base;
        penalties_.classify(x, y, row.base, row.match);
      }
    }
  }

  PenaltyPair penalty(std::size_t step, cv::Point p, int d) const {
    const Row& row = classes_[step][static_cast<std::size_t>(p.y)];
    const int x_match = p.x - d;
    const bool inside = x_match >= 0 && x_match < shape_.width();
    return tables_[step].at(row.base[static_cast<std::size_t>(p.x)],
                            inside ? row.match[static_cast<std::size_t>(x_match)] : 0);
  }

  /// L_r(q, d), infinite outside the range of q.
  double at(cv::Point q, int d) {
    const int i = d - shape_.begin(q.y, q.x);
    const std::vector<double>& l = path_cost(q);
    return i >= 0 && i < static_cast<int>(l.size()) ? l[static_cast<std::size_t>(i)] : kInfinite;
  }

  bool counts(cv::Point q) {
    if (q.x < 0 || q.y < 0 || q.x >= shape_.width() || q.y >= shape_.height()) return false;
    return std::ranges::any_of(path_cost(q), [](double l) { return l < kInfinite; });
  }

  double term(std::size_t step, cv::Point p, int d) {
    const cv::Point q = p - cv::Point(steps_[step].dx, steps_[step].dy);
    const PenaltyPair penalty = this->penalty(step, p, d);
    return std::min({at(q, d), at(q, d - 1) + penalty.p1, at(q, d + 1) + penalty.p1,
                     std::ranges::min(path_cost(q)) + penalty.p2});
  }

  /// L_r(p, d) for all d of p.
  const std::vector<double>& path_cost(cv::Point p) {
    auto& known = known_[static_cast<std::size_t>(p.y * shape_.width() + p.x)];
    if (known) return *known;
    std::vector<std::size_t> steps;
    for (std::size_t s = 0; s < steps_.size(); ++s)
      if (counts(p - cv::Point(steps_[s].dx, steps_[s].dy))) steps.push_back(s);
    std::vector<double> l;
    for (int d = shape_.begin(p.y, p.x); d < shape_.end(p.y, p.x); ++d) {
      const std::uint8_t c = costs_.at(p.y, p.x)[d - shape_.begin(p.y, p.x)];
      double mean = 0;
      for (const std::size_t s : steps) mean += term(s, p, d) / double(steps.size());
      l.push_back(c == CostVolume::kNoMatch ? kInfinite : c + mean);
    }
    known = l;
    return *known;
  }

  struct Row {
    std::vector<std::uint8_t> base, match;
  };

  const CostVolume& costs_;
  const VolumeShape& shape_;
  const PenaltyField& penalties_;
  Method method_;
  std::vector<Direction> steps_;
  std::vector<PenaltyTable> tables_;
  std::vector<std::vector<Row>> classes_;                  // step, y
  std::vector<std::optional<std::vector<double>>> known_;  // pixel
};

/// Sums in units of a cost, infinite at kNoMatch.
inline Sums to_sums(const AggregatedVolume& volume) {
  Sums sums;
  for (std::int64_t i = 0; i < volume.shape().cells(); ++i) {
    const std::uint16_t s = volume.data()[i];
    sums.push_back(s == AggregatedVolume::kNoMatch ? kInfinite
                                                   : s / double(1 << volume.fraction_bits));
  }
  return sums;
}

/// Takes from every cell the least value of its pixel.
inline Sums less_minimum(const VolumeShape& shape, Sums sums) {
  for (int y = 0; y < shape.height(); ++y)
    for (int x = 0; x < shape.width(); ++x) {
      const auto begin = sums.begin() + shape.offset(y, x), end = begin + shape.count(y, x);
      const double minimum = begin == end ? kInfinite : *std::min_element(begin, end);
      if (minimum < kInfinite)
        for (auto s = begin; s != end; ++s) *s -= minimum;
    }
  return sums;
}

}  // namespace xgm::testing
