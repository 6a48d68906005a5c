// SPDX-License-Identifier: Apache-2.0
// Walks through a pipeline without running it, and keeps the books of memory and work.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "xgm/base/export.hpp"
#include "xgm/stage/needs.hpp"

namespace xgm {

struct PlanLedger;

/// Where a stage stands in a plan, as Context is in a run. A matcher that holds stages overrides
/// plan() and does there with slot.plan() and hold() what its run() does with slots and images:
/// the same stages in the same order, and whatever is held as long as there.
class XGM_API Planner {
 public:
  explicit Planner(PlanLedger& ledger) : ledger_(&ledger) {}

  /// Memory that is held as long as this lives.
  class XGM_API Hold {
   public:
    Hold() = default;
    Hold(Hold&& other) noexcept;
    Hold& operator=(Hold&& other) noexcept;
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;
    ~Hold() { release(); }
    void release();

   private:
    friend class Planner;
    PlanLedger* ledger_ = nullptr;
    double others_ = 0, volumes_ = 0;
  };

  /// The planner of something inside this stage: a level, a view.
  Planner scope(std::string_view name) const;
  /// Memory other than that of volumes.
  [[nodiscard]] Hold hold(double bytes) const;
  /// The stage that stands here has these needs. What it returns is held by the result.
  [[nodiscard]] Hold take(const Needs& needs) const;
  /// What was freed until now is in pieces too small for what follows: it stays with the process,
  /// but is not used again.
  void leave_holes() const;
  /// What is known of this scene; empty: nothing.
  const std::optional<Narrowing>& narrowing() const;

  /// Used by slots: `body` plans the stage at this path.
  template <class Body>
  [[nodiscard]] Hold stage(std::string_view kind, const std::string& plugin, const Workload& load,
                           Body body) const {
    const std::size_t row = begin(kind, plugin, load);
    Hold result = body(*this);
    end(row);
    return result;
  }
  /// Used by pipelines: what was freed, of the heap or of volumes, goes back to the system.
  void drop_free_heap() const;
  void drop_free_volumes() const;

 private:
  std::size_t begin(std::string_view kind, const std::string& plugin, const Workload& load) const;
  void end(std::size_t row) const;

  PlanLedger* ledger_;
  std::string path_;
};

}  // namespace xgm
