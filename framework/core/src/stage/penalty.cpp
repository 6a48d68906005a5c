// SPDX-License-Identifier: Apache-2.0
#include "xgm/stage/penalty.hpp"

#include <algorithm>

namespace xgm {
namespace {

constexpr int kMaxClasses = 256;  // classes are bytes

/// Penalties of a plugin, looked at when they are asked for.
class WatchedField final : public PenaltyField {
 public:
  WatchedField(std::unique_ptr<const PenaltyField> field, Context context)
      : field_(std::move(field)), context_(std::move(context)) {}

  PenaltyTable table(Direction r) const override {
    PenaltyTable table = field_->table(r);
    context_.require_none(fault_of(table));
    return table;
  }

  void classify(Direction r, int y, std::span<std::uint8_t> base,
                std::span<std::uint8_t> match) const override {
    field_->classify(r, y, base, match);
    const PenaltyTable table = field_->table(r);
    require_below(table.base_classes, base, y);
    require_below(table.match_classes, match, y);
  }

 private:
  void require_below(int classes, std::span<const std::uint8_t> row, int y) const {
    std::uint8_t largest = 0;
    for (const std::uint8_t c : row) largest = std::max(largest, c);  // in vectors, unlike a search
    if (largest < classes) return;
    const auto first = std::ranges::find(row, largest);
    const cv::Point pixel(static_cast<int>(first - row.begin()), y);
    context_.require_none(Fault{"a class is not in the table", pixel});
  }

  std::unique_ptr<const PenaltyField> field_;
  Context context_;
};

}  // namespace

std::optional<Fault> fault_of(const PenaltyTable& table) {
  const auto some = [](int classes) { return classes >= 1 && classes <= kMaxClasses; };
  if (!some(table.base_classes) || !some(table.match_classes)) {
    return Fault{"the number of classes is not in 1 to 256"};
  }
  const auto pairs = static_cast<std::size_t>(table.base_classes * table.match_classes);
  if (table.entries.size() != pairs) {
    return Fault{"the table does not have an entry for each pair of classes"};
  }
  const bool ordered = std::ranges::all_of(
      table.entries, [](const PenaltyPair& pair) { return 0 <= pair.p1 && pair.p1 <= pair.p2; });
  return ordered ? std::nullopt : std::optional(Fault{"not 0 <= p1 <= p2"});
}

PenaltyField::~PenaltyField() = default;
void PenaltyField::classify(Direction, int, std::span<std::uint8_t> base,
                            std::span<std::uint8_t> match) const {
  std::fill(base.begin(), base.end(), std::uint8_t{0});
  std::fill(match.begin(), match.end(), std::uint8_t{0});
}

std::optional<Fault> Penalty::fault_of(const std::unique_ptr<const PenaltyField>& result,
                                       const ImagePair&, const Context&) {
  return result != nullptr ? std::nullopt : std::optional(Fault{"there is no penalty field"});
}

std::unique_ptr<const PenaltyField> Penalty::watched(std::unique_ptr<const PenaltyField> field,
                                                     const Context& context) {
  return std::make_unique<const WatchedField>(std::move(field), context);
}

}  // namespace xgm
