// SPDX-License-Identifier: Apache-2.0
// Weighted median by quickselect: linear time on average, no memory of its own.
#include "plugins/filter/joint_bilateral/votes.hpp"

#include <algorithm>
#include <cstdint>

namespace xgm::joint_bilateral {
namespace {

float middle_of_three(float a, float b, float c) {
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

template <class Iterator>
std::int64_t weight_of(Iterator begin, Iterator end) {
  std::int64_t sum = 0;
  for (; begin != end; ++begin) sum += begin->weight;
  return sum;
}

}  // namespace

float Votes::weighted_median() {
  Vote* begin = votes_.data();
  Vote* end = begin + size_;
  std::int64_t wanted = (weight_of(begin, end) + 1) / 2;
  for (;;) {
    const float pivot =
        middle_of_three(begin->value, begin[(end - begin) / 2].value, end[-1].value);
    Vote* const equal = std::partition(begin, end, [=](Vote v) { return v.value < pivot; });
    const std::int64_t smaller = weight_of(begin, equal);
    if (wanted <= smaller) {
      end = equal;
      continue;
    }
    Vote* const larger = std::partition(equal, end, [=](Vote v) { return v.value == pivot; });
    wanted -= smaller + weight_of(equal, larger);
    if (wanted <= 0) return pivot;
    begin = larger;
  }
}

double Votes::weighted_mean() const {
  double sum = 0;
  std::int64_t weight = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    sum += static_cast<double>(votes_[i].weight) * static_cast<double>(votes_[i].value);
    weight += votes_[i].weight;
  }
  return sum / static_cast<double>(weight);
}

}  // namespace xgm::joint_bilateral
