// SPDX-License-Identifier: Apache-2.0
// Paths as recurrences: what a pixel sees along a step is itself, or else what the pixel one step
// ahead sees. Swept from the far end, each direction takes one pass over the map.
#include "plugins/filter/plane_filling/candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "xgm/base/parallel.hpp"

namespace xgm::plane_filling {
namespace {

constexpr std::size_t kDirections = 8;
const std::array<cv::Point, kDirections> kSteps{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};

/// The first pixel with a disparity on a path, and the colour differences on the way to it.
struct Seen {
  int x = -1, y = -1;  ///< -1: nothing
  float path = 0;
};

void number_holes(const DisparityMap& map, const Image& image, Holes& holes) {
  holes.number = cv::Mat1i(map.size(), -1);
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      const bool hole = !map.has_disparity(y, x) && map.at(y, x) != Status::masked;
      if (!hole || !image.is_valid(y, x)) continue;
      holes.number(y, x) = static_cast<int>(holes.at.size());
      holes.at.emplace_back(x, y);
    }
  }
}

/// What each hole sees along `step`.
std::vector<Seen> look(const DisparityMap& map, const Image& image, const Holes& holes,
                       cv::Point step) {
  const cv::Rect inside({}, map.size());
  const auto width = static_cast<std::size_t>(map.size().width);
  std::vector<Seen> last_row(width), row(width), seen(holes.at.size());
  for (int i = 0; i < map.size().height; ++i) {
    const int y = step.y > 0 ? map.size().height - 1 - i : i;
    for (int j = 0; j < map.size().width; ++j) {
      const int x = step.x > 0 ? map.size().width - 1 - j : j;
      const cv::Point here(x, y), ahead = here + step;
      Seen& what = row[static_cast<std::size_t>(x)];
      if (map.has_disparity(y, x) && image.is_valid(y, x)) {
        what = {x, y, 0};
        continue;
      }
      if (!inside.contains(ahead)) {
        what = {};
        continue;
      }
      what = (step.y == 0 ? row : last_row)[static_cast<std::size_t>(ahead.x)];
      if (image.is_valid(y, x) && image.is_valid(ahead.y, ahead.x)) {
        what.path += colour_distance(image, here, ahead);
      }
      const int hole = holes.number(y, x);
      if (hole >= 0) seen[static_cast<std::size_t>(hole)] = what;
    }
    std::swap(row, last_row);
  }
  return seen;
}

/// Collects the candidates of one hole.
class Collector {
 public:
  Collector(const DisparityMap& map, const Segments& segments,
            const std::vector<std::optional<Plane>>& planes)
      : map_(map), segments_(segments), planes_(planes) {
    for (int y = 0; y < map.size().height; ++y) {
      for (int x = 0; x < map.size().width; ++x) {
        if (!map.has_disparity(y, x)) continue;
        lowest_ = std::min(lowest_, map.disparity(y, x));
        highest_ = std::max(highest_, map.disparity(y, x));
      }
    }
  }

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
    return lowest_ <= disparity && disparity <= highest_;
  }
  void add(const Plane& plane, float path) {
    for (std::size_t i = 0; i < count_; ++i) {
      const Plane& other = list_[i].plane;
      const bool same = other.along_x == plane.along_x && other.along_y == plane.along_y &&
                        other.offset == plane.offset;
      if (!same) continue;
      list_[i].path = std::min(list_[i].path, path);
      return;
    }
    list_[count_++] = {plane, plane.at(hole_.y, hole_.x), path};
  }

  const DisparityMap& map_;
  const Segments& segments_;
  const std::vector<std::optional<Plane>>& planes_;
  float lowest_ = std::numeric_limits<float>::infinity(), highest_ = -lowest_;
  cv::Point hole_;
  std::array<Candidate, kDirections + 2> list_;
  std::size_t count_ = 0;
};

}  // namespace

Holes find_candidates(const DisparityMap& map, const cv::Mat1f& doubted, const Image& image,
                      const Segments& segments, const std::vector<std::optional<Plane>>& planes) {
  Holes holes;
  number_holes(map, image, holes);
  std::array<std::vector<Seen>, kDirections> seen;
  parallel_for(0, static_cast<int>(kDirections), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    seen[k] = look(map, image, holes, kSteps[k]);
  });
  Collector collector(map, segments, planes);
  holes.begin.push_back(0);
  for (std::size_t hole = 0; hole < holes.at.size(); ++hole) {
    collector.begin(holes.at[hole], doubted(holes.at[hole]));
    for (const std::vector<Seen>& along : seen) collector.offer(along[hole]);
    const std::span<const Candidate> found = collector.found();
    holes.candidates.insert(holes.candidates.end(), found.begin(), found.end());
    holes.begin.push_back(holes.candidates.size());
  }
  return holes;
}

}  // namespace xgm::plane_filling
