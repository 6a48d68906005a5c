// SPDX-License-Identifier: Apache-2.0
// The books of a plan: what is held now, and the most that was held while each stage ran.
#pragma once

#include <algorithm>
#include <vector>

#include "xgm/pipeline/plan.hpp"

namespace xgm {

/// Memory that is freed waits to be used again, in the heap or as BufferReuse says, until it is
/// given back to the system: the highest sums since then are what the process holds.
class PlanLedger {
 public:
  explicit PlanLedger(double program) : heap_(program), max_heap_(program) {}

  void begin(std::size_t stage) {
    open_.push_back(stage);
    add(0, 0);
  }
  void end() { open_.pop_back(); }

  void add(double heap, double volumes) {
    heap_ += heap;
    volumes_ += volumes;
    max_heap_ = std::max(max_heap_, heap_);
    max_volumes_ = std::max(max_volumes_, volumes_);
    const double memory = max_heap_ + max_volumes_;
    for (const std::size_t stage : open_) {
      stages[stage].memory = std::max(stages[stage].memory, memory);
    }
    peak_bytes = std::max(peak_bytes, memory);
    if (heap_ + volumes_ > max_used_ && !open_.empty()) {
      max_used_ = heap_ + volumes_;
      peak_stage = open_.back();
    }
  }

  void give_back_heap() { max_heap_ = heap_; }
  void give_back_volumes() { max_volumes_ = volumes_; }

  std::vector<PlannedStage> stages;
  double peak_bytes = 0;
  std::size_t peak_stage = 0;  ///< in which the most is in use, not only kept for later

 private:
  double heap_, max_heap_;
  double volumes_ = 0, max_volumes_ = 0;
  double max_used_ = 0;
  std::vector<std::size_t> open_;  ///< stages that run now, outermost first
};

}  // namespace xgm
