// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/shared/step_penalties.hpp"

#include <algorithm>
#include <span>

namespace xgm::aggregation {
namespace {

/// out[i] = table[classes[i]].
template <class Cell>
void look_up(const Cell* table, int classes_in_table, const std::uint8_t* __restrict classes,
             int count, Cell* __restrict out) {
  if (classes_in_table == 2) {  // the usual number, and the compiler can vectorise a choice of two
    const Cell first = table[0], second = table[1];
    for (int i = 0; i < count; ++i) out[i] = classes[i] == 0 ? first : second;
  } else {
    for (int i = 0; i < count; ++i) out[i] = table[classes[i]];
  }
}

}  // namespace

template <class Cell>
StepPenalties<Cell>::StepPenalties(const PenaltyField& field, Direction step, int rows, int width,
                                   Cell unit)
    : field_(field), step_(step), width_(width) {
  const PenaltyTable table = field.table(step);
  match_classes_ = table.match_classes;
  for (const PenaltyPair& pair : table.entries) {
    p1_.push_back(static_cast<Cell>(pair.p1 * unit));
    p2_.push_back(static_cast<Cell>(pair.p2 * unit));
  }
  if (table.base_classes > 1) base_.create(rows, width);
  if (table.match_classes > 1) match_.create(rows, width);
}

template <class Cell>
void StepPenalties<Cell>::load(int slot, int y) {
  if (base_.empty() && match_.empty()) return;
  const auto width = static_cast<std::size_t>(width_);
  std::vector<std::uint8_t> base(width), match(width);
  field_.classify(step_, y, base, match);
  if (!base_.empty()) std::ranges::copy(base, base_[slot]);
  if (!match_.empty()) std::ranges::reverse_copy(match, match_[slot]);
}

template <class Cell>
void StepPenalties<Cell>::of_cells(int slot, int x, int begin, int count, Cell* p1,
                                   Cell* p2) const {
  const Cell* const table1 = this->p1(slot, x);
  const Cell* const table2 = this->p2(slot, x);
  // Disparities whose match pixel lies inside the image: x - width < d <= x. The others cannot be
  // matched, so that any penalty will do; but it must be one, for other cells' minima.
  const int inside_begin = std::clamp(x - width_ + 1 - begin, 0, count);
  const int inside_end = match_.empty() ? inside_begin : std::clamp(x + 1 - begin, 0, count);
  const int inside = inside_end - inside_begin;
  std::fill(p1, p1 + inside_begin, table1[0]);
  std::fill(p2, p2 + inside_begin, table2[0]);
  std::fill(p1 + inside_end, p1 + count, table1[0]);
  std::fill(p2 + inside_end, p2 + count, table2[0]);
  if (inside == 0) return;
  const std::uint8_t* const classes = match_[slot] + (width_ - 1 - x + begin + inside_begin);
  look_up(table1, match_classes_, classes, inside, p1 + inside_begin);
  look_up(table2, match_classes_, classes, inside, p2 + inside_begin);
}

template class StepPenalties<std::uint8_t>;
template class StepPenalties<std::uint16_t>;

}  // namespace xgm::aggregation
