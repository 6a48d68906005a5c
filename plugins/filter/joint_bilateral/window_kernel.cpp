// SPDX-License-Identifier: Apache-2.0
// Weighted medians of neighbouring pixels at once, one per lane.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "plugins/filter/joint_bilateral/votes.hpp"
#include "plugins/filter/joint_bilateral/window.hpp"
#include "xgm/base/simd_dispatch.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/filter/joint_bilateral/window_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace xgm::joint_bilateral::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128

void FilterRow(const Scene& scene, Mode mode, int y, float* filtered) {
  plain_filter(scene, mode, y, {0, scene.disparity.cols}, filtered);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kMaxLanes = 16;
using Floats = hn::CappedTag<float, kMaxLanes>;
using Ints = hn::RebindToSigned<Floats>;
using VF = hn::Vec<Floats>;
using VI = hn::Vec<Ints>;

/// The votes of as many windows as there are lanes.
class VoteVectors {
 public:
  std::size_t size() const { return size_ / hn::Lanes(Floats()); }
  void clear() { size_ = 0; }
  void add(VF value, VI weight) {
    hn::Store(value, Floats(), values_ + size_);
    hn::Store(weight, Ints(), weights_ + size_);
    size_ += hn::Lanes(Floats());
  }
  VF value(std::size_t i) const { return hn::Load(Floats(), values_ + i * hn::Lanes(Floats())); }
  VI weight(std::size_t i) const { return hn::Load(Ints(), weights_ + i * hn::Lanes(Floats())); }

 private:
  static constexpr std::size_t kSide = 2 * kMaxRadius + 1;
  HWY_ALIGN float values_[kSide * kSide * kMaxLanes];
  HWY_ALIGN std::int32_t weights_[kSide * kSide * kMaxLanes];
  std::size_t size_ = 0;
};

/// Mean absolute difference of the planes between the pixels from x in row y and those from column
/// in row. The same operations in the same order as without vectors.
template <std::size_t kPlanes>
VF ColourDistance(const Scene& scene, int y, int x, int row, int column) {
  const Floats d;
  VF sum = hn::Zero(d);
  for (std::size_t c = 0; c < kPlanes; ++c) {
    const cv::Mat1f& plane = scene.guide[c];
    sum = hn::Add(sum,
                  hn::Abs(hn::Sub(hn::LoadU(d, plane[row] + column), hn::LoadU(d, plane[y] + x))));
  }
  return kPlanes == 1 ? sum : hn::Div(sum, hn::Set(d, static_cast<float>(kPlanes)));
}

/// Weights::operator() for each lane.
VI WeightsOf(const Weights& weights, float space, VF colour_distance) {
  const Floats d;
  const Ints di;
  const VF half = hn::Set(d, 0.5F);
  const VF step =
      hn::Add(hn::Mul(colour_distance, hn::Set(d, static_cast<float>(Weights::kSteps))), half);
  const auto near = hn::Lt(step, hn::Set(d, static_cast<float>(weights.range().size())));
  const VI place = hn::ConvertTo(di, hn::IfThenElseZero(near, step));
  const VF range = hn::GatherIndex(d, weights.range().data(), place);
  const VF weight = hn::Add(hn::Mul(hn::Set(d, space), range), half);
  return hn::ConvertTo(di, hn::IfThenElseZero(near, weight));
}

/// The votes for the pixels from x in row y; all columns of their windows lie inside the image.
/// Who has no vote, votes for the centre with weight 0, which changes nothing.
template <std::size_t kPlanes>
void Collect(const Scene& scene, int y, int x, VoteVectors& votes) {
  const Floats d;
  const Ints di;
  const int radius = scene.weights.radius();
  const int bottom = std::min(scene.disparity.rows, y + radius + 1);
  const VF centre = hn::LoadU(d, scene.disparity[y] + x);
  const auto wanted = hn::Eq(centre, centre);  // not NaN
  votes.clear();
  for (int row = std::max(0, y - radius); row < bottom; ++row) {
    const float* space = scene.weights.space_row(row - y);
    for (int dx = -radius; dx <= radius; ++dx) {
      const VF value = hn::LoadU(d, scene.disparity[row] + x + dx);
      const auto votes_here = hn::And(wanted, hn::Eq(value, value));
      const VI weight =
          WeightsOf(scene.weights, space[dx], ColourDistance<kPlanes>(scene, y, x, row, x + dx));
      votes.add(hn::Add(hn::IfThenElse(votes_here, value, centre), hn::Zero(d)),  // -0 is 0
                hn::IfThenElseZero(hn::RebindMask(di, votes_here), weight));
    }
  }
}

/// The smallest value such that it and all smaller ones have at least half of the weight. Halves
/// the interval [low, high] that it lies in; both ends are always votes, so that they meet soon.
VF SmallestWithHalf(const VoteVectors& votes, VI total) {
  const Floats d;
  const Ints di;
  const VI half = hn::ShiftRight<1>(hn::Add(total, hn::Set(di, 1)));
  VF low = votes.value(0), high = low;
  for (std::size_t i = 1; i < votes.size(); ++i) {
    low = hn::Min(low, votes.value(i));
    high = hn::Max(high, votes.value(i));
  }
  while (!hn::AllFalse(d, hn::Lt(low, high))) {
    VF middle = hn::Add(low, hn::Mul(hn::Sub(high, low), hn::Set(d, 0.5F)));
    middle = hn::IfThenElse(hn::Lt(middle, high), middle, low);  // should rounding reach high
    VI weight = hn::Zero(di);
    VF below = low, above = high;  // the votes next to the middle
    for (std::size_t i = 0; i < votes.size(); ++i) {
      const VF value = votes.value(i);
      const auto is_below = hn::Le(value, middle);
      weight = hn::Add(weight, hn::IfThenElseZero(hn::RebindMask(di, is_below), votes.weight(i)));
      below = hn::Max(below, hn::IfThenElse(is_below, value, low));
      above = hn::Min(above, hn::IfThenElse(is_below, high, value));
    }
    const auto enough = hn::RebindMask(d, hn::Not(hn::Lt(weight, half)));
    high = hn::IfThenElse(enough, below, high);
    low = hn::IfThenElse(enough, low, above);
  }
  return low;
}

/// In double, as without vectors; weight 0 adds exactly 0.
VF WeightedMean(const VoteVectors& votes, VI total) {
  using Doubles = hn::Repartition<double, Floats>;
  const Doubles dd;
  const hn::Half<Floats> dh;
  const hn::Half<Ints> dih;
  auto lower = hn::Zero(dd), upper = hn::Zero(dd);
  for (std::size_t i = 0; i < votes.size(); ++i) {
    const VF value = votes.value(i);
    const VI weight = votes.weight(i);
    lower = hn::Add(lower, hn::Mul(hn::PromoteTo(dd, hn::LowerHalf(dih, weight)),
                                   hn::PromoteTo(dd, hn::LowerHalf(dh, value))));
    upper = hn::Add(upper, hn::Mul(hn::PromoteTo(dd, hn::UpperHalf(dih, weight)),
                                   hn::PromoteTo(dd, hn::UpperHalf(dh, value))));
  }
  lower = hn::Div(lower, hn::PromoteTo(dd, hn::LowerHalf(dih, total)));
  upper = hn::Div(upper, hn::PromoteTo(dd, hn::UpperHalf(dih, total)));
  return hn::Combine(Floats(), hn::DemoteTo(dh, upper), hn::DemoteTo(dh, lower));
}

/// One vector of pixels.
template <std::size_t kPlanes>
void FilterAt(const Scene& scene, Mode mode, int y, int x, VoteVectors& votes, float* filtered) {
  const Floats d;
  const Ints di;
  const VF centre = hn::LoadU(d, scene.disparity[y] + x);
  if (hn::AllFalse(d, hn::Eq(centre, centre))) return;
  Collect<kPlanes>(scene, y, x, votes);
  VI total = hn::Zero(di);
  for (std::size_t i = 0; i < votes.size(); ++i) total = hn::Add(total, votes.weight(i));
  const VF result =
      mode == Mode::median ? SmallestWithHalf(votes, total) : WeightedMean(votes, total);
  const auto some = hn::RebindMask(d, hn::Gt(total, hn::Zero(di)));
  hn::StoreU(hn::IfThenElse(some, result, hn::LoadU(d, filtered + x)), d, filtered + x);
}

template <std::size_t kPlanes>
void FilterColumns(const Scene& scene, Mode mode, int y, cv::Range columns, float* filtered) {
  const int lanes = static_cast<int>(hn::Lanes(Floats()));
  VoteVectors votes;
  for (int x = columns.start; x < columns.end; x += lanes) {
    // The last vector goes back over pixels that are done: it reads none of the results.
    FilterAt<kPlanes>(scene, mode, y, std::min(x, columns.end - lanes), votes, filtered);
  }
}

void FilterRow(const Scene& scene, Mode mode, int y, float* filtered) {
  const int cols = scene.disparity.cols, radius = scene.weights.radius();
  const cv::Range whole(radius, cols - radius);  // columns whose windows lie inside the image
  if (whole.end - whole.start < static_cast<int>(hn::Lanes(Floats()))) {
    return plain_filter(scene, mode, y, {0, cols}, filtered);
  }
  plain_filter(scene, mode, y, {0, whole.start}, filtered);
  if (scene.guide.size() == 1) {
    FilterColumns<1>(scene, mode, y, whole, filtered);
  } else {
    FilterColumns<3>(scene, mode, y, whole, filtered);
  }
  plain_filter(scene, mode, y, {whole.end, cols}, filtered);
}

#endif

}  // namespace xgm::joint_bilateral::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace xgm::joint_bilateral {

HWY_EXPORT(FilterRow);

void filter_row(const Scene& scene, Mode mode, int y, float* filtered) {
  XGM_SIMD_DISPATCH(FilterRow)(scene, mode, y, filtered);
}

}  // namespace xgm::joint_bilateral
#endif
