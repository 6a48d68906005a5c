// SPDX-License-Identifier: Apache-2.0
// Paths as recurrences: what a hole sees along a step is the pixel one step ahead, or else what
// that one sees.
#include "plugins/filter/plane_filling/candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "xgm/base/parallel.hpp"

namespace xgm::plane_filling {
namespace {

/// The first pixel with a disparity on a path, and the colour differences on the way to it.
struct Seen {
  int x = -1, y = -1;  ///< -1: nothing
  float path = 0;
};

/// What each hole sees along step k.
std::vector<Seen> look(const Holes& holes, std::size_t k) {
  const cv::Rect inside({}, holes.number.size());
  const bool ascending = k < kDirections / 2;  // the hole ahead comes earlier
  const std::size_t count = holes.at.size();
  std::vector<Seen> seen(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t hole = ascending ? i : count - 1 - i;
    const cv::Point ahead = holes.at[hole] + kSteps[k];
    if (!inside.contains(ahead)) continue;
    const int number = holes.number(ahead);
    seen[hole] = number < 0 ? Seen{ahead.x, ahead.y} : seen[static_cast<std::size_t>(number)];
    seen[hole].path += holes.distance[hole][k];
  }
  return seen;
}

struct Interval {
  float lowest = std::numeric_limits<float>::infinity(), highest = -lowest;
};

Interval disparities_of(const DisparityMap& map) {
  std::vector<Interval> rows(static_cast<std::size_t>(map.size().height));
  parallel_for(0, map.size().height, [&](int y) {
    Interval& row = rows[static_cast<std::size_t>(y)];
    for (int x = 0; x < map.size().width; ++x) {
      if (!map.has_disparity(y, x)) continue;
      row.lowest = std::min(row.lowest, map.disparity(y, x));
      row.highest = std::max(row.highest, map.disparity(y, x));
    }
  });
  Interval all;
  for (const Interval& row : rows) {
    all = {std::min(all.lowest, row.lowest), std::max(all.highest, row.highest)};
  }
  return all;
}

/// Collects the candidates of one hole.
class Collector {
 public:
  Collector(const DisparityMap& map, const Segments& segments,
            const std::vector<std::optional<Plane>>& planes, const Interval& possible)
      : map_(map), segments_(segments), planes_(planes), possible_(possible) {}

  void begin(cv::Point hole, float doubted) {
    hole_ = hole;
    count_ = 0;
    if (!std::isnan(doubted)) add({0, 0, doubted}, 0);
    const int label = segments_.label(hole);
    const std::optional<Plane>& own = planes_[static_cast<std::size_t>(label)];
    if (own && is_possible(*own)) add(*own, 0);
  }
  void offer(const Seen& seen) {
    if (seen.x < 0) return;
    const float disparity = map_.disparity(seen.y, seen.x);
    const int label = segments_.label(seen.y, seen.x);
    const std::optional<Plane>& plane = planes_[static_cast<std::size_t>(label)];
    const bool lies = plane && std::abs(plane->at(seen.y, seen.x) - disparity) < kInlier;
    if (lies && is_possible(*plane)) {
      add(*plane, seen.path);
    } else {
      add({0, 0, disparity}, seen.path);
    }
  }
  std::span<const Candidate> found() const { return {list_.data(), count_}; }

 private:
  bool is_possible(const Plane& plane) const {
    const float disparity = plane.at(hole_.y, hole_.x);
    return possible_.lowest <= disparity && disparity <= possible_.highest;
  }
  void add(const Plane& plane, float path) {
    for (std::size_t i = 0; i < count_; ++i) {
      const Plane& other = list_[i].plane;
      const bool same = other.offset == plane.offset && other.along_x == plane.along_x &&
                        other.along_y == plane.along_y;
      if (!same) continue;
      list_[i].path = std::min(list_[i].path, path);
      return;
    }
    list_[count_++] = {plane, plane.at(hole_.y, hole_.x), path};
  }

  const DisparityMap& map_;
  const Segments& segments_;
  const std::vector<std::optional<Plane>>& planes_;
  Interval possible_;
  cv::Point hole_;
  std::array<Candidate, kMostCandidates> list_;
  std::size_t count_ = 0;
};

}  // namespace

CandidateLists find_candidates(const Holes& holes, const DisparityMap& map,
                               const cv::Mat1f& doubted, const Segments& segments,
                               const std::vector<std::optional<Plane>>& planes) {
  std::array<std::vector<Seen>, kDirections> seen;
  parallel_for(0, static_cast<int>(kDirections), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    seen[k] = look(holes, k);
  });
  const Interval possible = disparities_of(map);
  const std::size_t count = holes.at.size();
  CandidateLists candidates{std::vector<std::size_t>(count + 1, 0), {}};
  // Each part of the holes collects its own, and the parts are put one behind the other.
  constexpr std::size_t kPart = 4096;
  std::vector<std::vector<Candidate>> parts((count + kPart - 1) / kPart);
  parallel_for(0, static_cast<int>(parts.size()), [&](int i) {
    const auto part = static_cast<std::size_t>(i);
    Collector collector(map, segments, planes, possible);
    for (std::size_t hole = part * kPart; hole < std::min(count, (part + 1) * kPart); ++hole) {
      if (holes.is_filled[hole] == 0) continue;
      collector.begin(holes.at[hole], doubted(holes.at[hole]));
      for (const std::vector<Seen>& along : seen) collector.offer(along[hole]);
      const std::span<const Candidate> found = collector.found();
      parts[part].insert(parts[part].end(), found.begin(), found.end());
      candidates.begin[hole + 1] = found.size();
    }
  });
  std::partial_sum(candidates.begin.begin(), candidates.begin.end(), candidates.begin.begin());
  candidates.all.reserve(candidates.begin.back());
  for (const std::vector<Candidate>& part : parts) {
    candidates.all.insert(candidates.all.end(), part.begin(), part.end());
  }
  return candidates;
}

}  // namespace xgm::plane_filling
