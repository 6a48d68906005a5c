// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/shared/step_penalties.hpp"

#include <algorithm>
#include <span>

#include "xgm/data/volume.hpp"

namespace xgm::aggregation {

template <class Cell>
StepPenalties<Cell>::StepPenalties(const PenaltyField& field, Direction step, int rows, int width,
                                   Interval hull, int unit)
    : field_(field), step_(step), width_(width), hull_(hull) {
  const PenaltyTable table = field.table(step);
  one_base_class_ = table.base_classes == 1;
  match_classes_ = table.match_classes;
  for (const PenaltyPair& pair : table.entries) {
    p1_.push_back(static_cast<Cell>(pair.p1 * unit));
    p2_.push_back(static_cast<Cell>(pair.p2 * unit));
  }
  if (table.base_classes > 1) base_ = cv::Mat1b(rows, width, std::uint8_t{0});
  // Whole granules are read at any disparity of the hull.
  if (table.match_classes > 1)
    match_ = cv::Mat1b(rows, width + hull.size() + VolumeShape::kGranule, std::uint8_t{0});
}

template <class Cell>
void StepPenalties<Cell>::load(int slot, int y) {
  if (base_.empty() && match_.empty()) return;
  const auto width = static_cast<std::size_t>(width_);
  std::vector<std::uint8_t> base(width), match(width);
  field_.classify(step_, y, base, match);
  if (!base_.empty()) std::ranges::copy(base, base_[slot]);
  if (match_.empty()) return;
  // Match pixel x - d is element width - 1 - x + d - hull.begin; those of the image begin at:
  const int first = -hull_.begin;
  const int begin = std::max(0, -first), end = std::min(width_, match_.cols - first);
  for (int i = begin; i < end; ++i)
    match_(slot, first + i) = match[static_cast<std::size_t>(width_ - 1 - i)];
}

template class StepPenalties<std::uint8_t>;
template class StepPenalties<std::uint16_t>;

}  // namespace xgm::aggregation
