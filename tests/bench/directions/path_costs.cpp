// SPDX-License-Identifier: Apache-2.0
#include "bench/directions/path_costs.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "xgm/base/error.hpp"

namespace xgm::directions {
namespace {

using Paths = Volume<std::uint16_t>;

constexpr int kInfinite = 1 << 20;  // above all path costs, far from overflow

int cost_at(const Paths& paths, int y, int x, int disparity) {
  const int i = disparity - paths.shape().begin(y, x);
  if (i < 0 || i >= paths.shape().count(y, x)) return kInfinite;
  const int cost = paths.at(y, x)[i];
  return cost == Paths::kNoMatch ? kInfinite : cost;
}

int lowest(const Paths& paths, int y, int x) {
  int low = kInfinite;
  for (const int cost : paths.cells(y, x)) low = std::min(low, cost);
  return low == Paths::kNoMatch ? kInfinite : low;
}

/// The penalties of a row of pixels.
struct RowPenalties {
  RowPenalties(const PenaltyField& penalties, Direction r, int width)
      : field(penalties),
        direction(r),
        table(penalties.table(r)),
        base(static_cast<std::size_t>(width)),
        match(base.size()) {}

  void load(int y) { field.classify(direction, y, base, match); }
  const PenaltyPair& at(int x, int disparity) const {
    return table.at(base[static_cast<std::size_t>(x)],
                    match[static_cast<std::size_t>(x - disparity)]);
  }

  const PenaltyField& field;
  Direction direction;
  PenaltyTable table;
  std::vector<std::uint8_t> base, match;
};

int message(const Paths& paths, cv::Point before, int low, int disparity, const PenaltyPair& p) {
  const int same = cost_at(paths, before.y, before.x, disparity);
  const int beside = std::min(cost_at(paths, before.y, before.x, disparity - 1),
                              cost_at(paths, before.y, before.x, disparity + 1));
  return std::min({same, beside + p.p1, low + p.p2}) - low;
}

void extend(const CostVolume& costs, const RowPenalties& penalties, int y, int x, Paths& paths) {
  const VolumeShape& shape = costs.shape();
  const Direction r = penalties.direction;
  const cv::Point before(x - r.dx, y - r.dy);
  const bool exists = cv::Rect({}, shape.size()).contains(before);
  const int low = exists ? lowest(paths, before.y, before.x) : kInfinite;
  for (int i = 0; i < shape.count(y, x); ++i) {
    const int cost = costs.at(y, x)[i], disparity = shape.begin(y, x) + i;
    int path = Paths::kNoMatch;
    if (cost != CostVolume::kNoMatch) {
      path = cost;
      if (low < kInfinite) {
        path += message(paths, before, low, disparity, penalties.at(x, disparity));
      }
    }
    paths.at(y, x)[i] = static_cast<std::uint16_t>(path);
  }
}

}  // namespace

Paths path_costs(const CostVolume& costs, const PenaltyField& field, Direction r) {
  const VolumeShape& shape = costs.shape();
  Paths paths(costs.shape_ptr());
  RowPenalties penalties(field, r, shape.width());
  const bool forward = r.dy > 0 || (r.dy == 0 && r.dx > 0);
  for (int j = 0; j < shape.height(); ++j) {
    const int y = forward ? j : shape.height() - 1 - j;
    penalties.load(y);
    for (int k = 0; k < shape.width(); ++k) {
      extend(costs, penalties, y, forward ? k : shape.width() - 1 - k, paths);
    }
  }
  return paths;
}

void require_sum(const std::vector<Paths>& paths, const CostVolume& costs,
                 const AggregatedVolume& sums) {
  const VolumeShape& shape = costs.shape();
  const int more = static_cast<int>(paths.size()) - 1;
  for (int y = 0; y < shape.height(); ++y) {
    for (int x = 0; x < shape.width(); ++x) {
      for (int i = 0; i < shape.count(y, x); ++i) {
        if (costs.at(y, x)[i] == CostVolume::kNoMatch) continue;
        int sum = -more * costs.at(y, x)[i];
        for (const Paths& path : paths) sum += path.at(y, x)[i];
        if (sum == sums.at(y, x)[i]) continue;
        throw Error("the path costs at pixel (" + std::to_string(x) + ", " + std::to_string(y) +
                    ") do not add up to the sum of the aggregation");
      }
    }
  }
}

}  // namespace xgm::directions
