// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/path_engine/pass_penalties.hpp"

#include <algorithm>
#include <utility>

#include "xgm/data/volume.hpp"

namespace xgm::aggregation {
namespace {

template <class Classes>
int max_classes(const std::vector<PenaltyTable>& tables, Classes classes) {
  int maximum = 1;
  for (const PenaltyTable& table : tables) maximum = std::max(maximum, table.*classes);
  return maximum;
}

}  // namespace

PixelClasses::PixelClasses(int classes, int steps, int rows, int width)
    : classes_(classes), stride_(width), packed_(classes == 2 && steps <= kMaxPacked) {
  if (classes > 1) bytes_ = cv::Mat1b(rows, packed_ ? width : width * steps, std::uint8_t{0});
}

void PixelClasses::clear(int slot) {
  if (!bytes_.empty()) bytes_.row(slot).setTo(0);
}

void PixelClasses::add(int step, int slot, int first, std::span<const std::uint8_t> classes) {
  if (bytes_.empty()) return;
  const int begin = std::max(0, -first);
  const int end = std::min(static_cast<int>(classes.size()), stride_ - first);
  const int shift = packed_ ? step : 0;
  const std::uint8_t* const from = classes.data();
  std::uint8_t* const to = bytes_[slot] + (packed_ ? 0 : step * stride_) + first;
  for (int i = begin; i < end; ++i) to[i] |= static_cast<std::uint8_t>(from[i] << shift);
}

template <class Cell>
std::vector<PenaltyTable> PassPenalties<Cell>::tables_of(const PenaltyField& field,
                                                         const std::vector<Direction>& steps) {
  std::vector<PenaltyTable> tables;
  for (const Direction step : steps) tables.push_back(field.table(step));
  return tables;
}

template <class Cell>
PassPenalties<Cell>::PassPenalties(const PenaltyField& field, std::vector<Direction> steps,
                                   int rows, int width, Interval hull, int unit)
    : PassPenalties(field, steps, tables_of(field, steps), rows, width, hull, unit) {}

template <class Cell>
PassPenalties<Cell>::PassPenalties(const PenaltyField& field, std::vector<Direction> steps,
                                   const std::vector<PenaltyTable>& tables, int rows, int width,
                                   Interval hull, int unit)
    : field_(field),
      steps_(std::move(steps)),
      width_(width),
      hull_(hull),
      base_(max_classes(tables, &PenaltyTable::base_classes), static_cast<int>(tables.size()), rows,
            width),
      // A vector of up to 64 classes may be read from any disparity of the hull on.
      match_(max_classes(tables, &PenaltyTable::match_classes), static_cast<int>(tables.size()),
             rows, width + hull.size() + 64),
      row_(tables.size() * static_cast<std::size_t>(match_.count())) {
  for (const PenaltyTable& table : tables) {
    for (int base = 0; base < base_.count(); ++base) {
      for (int match = 0; match < match_.count(); ++match) {
        const PenaltyPair& pair = table.at(std::min(base, table.base_classes - 1),
                                           std::min(match, table.match_classes - 1));
        penalties_.push_back({Repeated(static_cast<Cell>(pair.p1 * unit)),
                              Repeated(static_cast<Cell>(pair.p2 * unit))});
      }
    }
  }
  if (base_.count() > 1 && !base_.packed()) return;
  const std::size_t combinations = base_.count() == 1 ? 1 : std::size_t{1} << tables.size();
  by_classes_.resize(combinations * row_);
  for (std::size_t i = 0; i < combinations; ++i) {
    const auto classes = static_cast<std::uint8_t>(i);
    look_up(&classes, &by_classes_[i * row_]);
  }
}

template <class Cell>
void PassPenalties<Cell>::look_up(const std::uint8_t* base_classes, StepPenalties* row) const {
  const int count = match_.count(), table = base_.count() * count;
  const StepPenalties* of_step = penalties_.data();
  for (int step = 0; step < static_cast<int>(steps_.size()); ++step, of_step += table) {
    const int own = base_.count() == 1 ? 0 : base_.get(step, base_classes);
    row = std::copy_n(of_step + own * count, count, row);
  }
}

template <class Cell>
void PassPenalties<Cell>::load(int slot, int y) {
  if (same_everywhere()) return;
  const auto width = static_cast<std::size_t>(width_);
  std::vector<std::uint8_t> base(width), match(width);
  base_.clear(slot);
  match_.clear(slot);
  for (int step = 0; step < static_cast<int>(steps_.size()); ++step) {
    field_.classify(steps_[static_cast<std::size_t>(step)], y, base, match);
    base_.add(step, slot, 0, base);
    if (match_.count() == 1) continue;
    // Match pixel x - d is element width - 1 - x + d - hull.begin.
    std::ranges::reverse(match);
    match_.add(step, slot, -hull_.begin, match);
  }
}

template class PassPenalties<std::uint8_t>;
template class PassPenalties<std::uint16_t>;

}  // namespace xgm::aggregation
