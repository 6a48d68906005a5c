// SPDX-License-Identifier: Apache-2.0
#include "plugins/pointing/bundle_adjustment/tracks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace xgm::geo {
namespace {

/// Which of the key points belong together. Galler, Fischer: An improved equivalence algorithm
/// (CACM 1964).
class Sets {
 public:
  std::size_t add() {
    parents_.push_back(parents_.size());
    return parents_.size() - 1;
  }
  std::size_t find(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    const std::size_t one = find(a), other = find(b);
    parents_[std::max(one, other)] = std::min(one, other);
  }

 private:
  std::vector<std::size_t> parents_;
};

}  // namespace

std::vector<Track> join_tracks(const std::vector<PairChoice>& pairs,
                               const std::vector<std::vector<KeypointMatch>>& matches) {
  // Key points of one image are found again in each of its pairs, to some thousandths of a pixel.
  constexpr double kSame = 100;  // per px
  std::map<std::tuple<std::size_t, long, long>, std::size_t> known;
  std::vector<Observation> observations;
  Sets sets;
  const auto number = [&](std::size_t image, cv::Point2d pixel) {
    const auto [place, is_new] = known.try_emplace(
        {image, std::lround(pixel.x * kSame), std::lround(pixel.y * kSame)}, observations.size());
    if (is_new) {
      observations.push_back({image, pixel});
      sets.add();
    }
    return place->second;
  };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (const KeypointMatch& m : matches[i]) {
      sets.join(number(pairs[i].base, m.base), number(pairs[i].match, m.match));
    }
  }
  std::map<std::size_t, Track> joined;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    joined[sets.find(i)].push_back(observations[i]);
  }
  std::vector<Track> tracks;
  for (auto& [first, track] : joined) {
    std::ranges::stable_sort(track, {}, &Observation::image);
    const bool twice = std::ranges::adjacent_find(track, {}, &Observation::image) != track.end();
    if (!twice && track.size() >= 2) tracks.push_back(std::move(track));
  }
  return tracks;
}

}  // namespace xgm::geo
