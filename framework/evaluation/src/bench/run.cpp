// SPDX-License-Identifier: Apache-2.0
// Runs what is not done, and judges all that is.
#include <algorithm>
#include <chrono>

#include "bench/identity.hpp"
#include "bench/judge.hpp"
#include "xgm/evaluation/bench.hpp"

namespace xgm {
namespace {

class Bench {
 public:
  Bench(const BenchRequest& request, const BenchRules& rules, const BenchHooks& hooks)
      : hooks_(hooks), result_{request, rules, {}} {}

  BenchResult run() {
    const std::size_t pipelines = result_.request.pipelines.size();
    const std::size_t total = pipelines * result_.request.scenes.size();
    result_.cells.resize(total);
    for (std::size_t i = 0; i < total; ++i) {
      if (!is_done(folder(i), identity(i))) missing_.push_back(i);
    }
    for (std::size_t i = 0; i < total; ++i) {
      const bool missing = std::binary_search(missing_.begin(), missing_.end(), i);
      if (missing && !result_.interrupted) run(i);
      if (!missing) judge(i);
    }
    return std::move(result_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t pipeline(std::size_t i) const { return i % result_.request.pipelines.size(); }
  std::size_t scene(std::size_t i) const { return i / result_.request.pipelines.size(); }
  std::string folder(std::size_t i) const {
    return cell_folder(result_.request, pipeline(i), scene(i));
  }
  std::string identity(std::size_t i) const {
    return cell_identity(result_.request, pipeline(i), scene(i));
  }

  void run(std::size_t i) {
    tell(i, nullptr);
    const auto begin = Clock::now();
    begin_cell(folder(i));
    const RunOutcome outcome = hooks_.run(result_.request.pipelines[pipeline(i)],
                                          result_.request.scenes[scene(i)], folder(i));
    if (outcome.interrupted) {
      result_.interrupted = true;
      return;
    }
    if (outcome.failure.empty()) {
      judge(i, [&] { mark_done(folder(i), identity(i)); });
    } else {
      result_.cells[i] = {.state = CellState::failed, .failure = outcome.failure};
    }
    seconds_ += std::chrono::duration<double>(Clock::now() - begin).count();
    ++runs_;
    tell(i, &result_.cells[i]);
  }

  void judge(
      std::size_t i, const std::function<void()>& before = [] {}) {
    try {
      before();
      result_.cells[i] = judge_cell(folder(i), result_.request.scenes[scene(i)], result_.rules);
    } catch (const std::exception& error) {
      result_.cells[i] = {.state = CellState::failed, .failure = error.what()};
    }
  }

  void tell(std::size_t i, const BenchCell* cell) const {
    const auto left = static_cast<double>(missing_.size() - runs_);
    hooks_.tell({.number = i + 1,
                 .total = result_.cells.size(),
                 .pipeline = result_.request.pipelines[pipeline(i)].name,
                 .scene = result_.request.scenes[scene(i)].files.name,
                 .finished = cell != nullptr,
                 .cell = cell,
                 .seconds_left = runs_ > 0 ? left * seconds_ / static_cast<double>(runs_) : -1});
  }

  const BenchHooks& hooks_;
  BenchResult result_;
  std::vector<std::size_t> missing_;  // cells, ascending
  std::size_t runs_ = 0;              // of the missing ones
  double seconds_ = 0;                // that they took
};

}  // namespace

BenchResult run_bench(const BenchRequest& request, const BenchRules& rules,
                      const BenchHooks& hooks) {
  return Bench(request, rules, hooks).run();
}

bool BenchResult::any_done(std::size_t scene) const {
  for (std::size_t i = 0; i < request.pipelines.size(); ++i) {
    if (at(i, scene).state == CellState::done) return true;
  }
  return false;
}

std::size_t BenchResult::failures() const {
  return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [](const auto& cell) {
    return cell.state == CellState::failed;
  }));
}

}  // namespace xgm
