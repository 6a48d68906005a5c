// SPDX-License-Identifier: Apache-2.0
#include "xgm/stage/planner.hpp"

#include <algorithm>
#include <utility>

#include "pipeline/ledger.hpp"

namespace xgm {

void PlanLedger::add(double more_others, double more_volumes) {
  others += more_others;
  volumes += more_volumes;
  max_others = std::max(max_others, others);
  max_volumes = std::max(max_volumes, volumes);
  const double memory = holes + max_others + max_volumes;
  for (const std::size_t row : open) stages[row].memory = std::max(stages[row].memory, memory);
  if (memory > peak_bytes && !open.empty()) {
    peak_bytes = memory;
    peak_row = open.back();
  }
}

Planner::Hold::Hold(Hold&& other) noexcept
    : ledger_(std::exchange(other.ledger_, nullptr)),
      others_(other.others_),
      volumes_(other.volumes_) {}

Planner::Hold& Planner::Hold::operator=(Hold&& other) noexcept {
  release();
  ledger_ = std::exchange(other.ledger_, nullptr);
  others_ = other.others_;
  volumes_ = other.volumes_;
  return *this;
}

void Planner::Hold::release() {
  if (ledger_ != nullptr) ledger_->add(-others_, -volumes_);
  ledger_ = nullptr;
}

Planner Planner::scope(std::string_view name) const {
  Planner inner = *this;
  if (!inner.path_.empty()) inner.path_ += '.';
  inner.path_ += name;
  return inner;
}

Planner::Hold Planner::hold(double bytes) const { return take({.others = bytes}); }

Planner::Hold Planner::take(const Needs& needs) const {
  if (!ledger_->open.empty()) {
    Needs& sum = ledger_->stages[ledger_->open.back()].needs;
    sum.updates += needs.updates;
    sum.moved += needs.moved;
  }
  Hold held;
  held.ledger_ = ledger_;
  held.others_ = needs.others;
  held.volumes_ = needs.volumes;
  ledger_->add(needs.others + needs.working, needs.volumes);
  ledger_->add(-needs.working, 0);
  return held;
}

const std::optional<Narrowing>& Planner::narrowing() const { return ledger_->narrowing; }

void Planner::leave_holes() const {
  ledger_->holes += ledger_->max_others - ledger_->others;
  ledger_->max_others = ledger_->others;
}

void Planner::drop_free_heap() const {
  leave_holes();
  ledger_->holes = 0;
}

void Planner::drop_free_volumes() const { ledger_->max_volumes = ledger_->volumes; }

std::size_t Planner::begin(std::string_view kind, const std::string& plugin,
                           const Workload& load) const {
  const std::size_t row = ledger_->stages.size();
  ledger_->stages.push_back(
      {.path = path_, .kind = std::string(kind), .plugin = plugin, .load = load});
  ledger_->open.push_back(row);
  ledger_->add(0, 0);
  return row;
}

void Planner::end(std::size_t row) const {
  PlannedStage& stage = ledger_->stages[row];
  // A stage that only calls others has work of its own, too, which grows with the images.
  stage.needs.updates = std::max(stage.needs.updates, stage.load.pixels());
  ledger_->open.pop_back();
}

}  // namespace xgm
