// SPDX-License-Identifier: Apache-2.0
#include "run_memory.hpp"

#include <spdlog/spdlog.h>

#include "common.hpp"
#include "xgm/base/memory.hpp"

namespace xgm::cli {
namespace {

/// What would make it fit.
std::string remedy(const RunTrace& trace, const PlanRequest& request, const RunPlan& plan,
                   double limit) {
  const Interval range = request.load.range;
  const std::string smaller = "match smaller images";
  std::string text = "search fewer disparities, ";
  if (!request.load.ragged) {
    const int fitting = max_disparities(trace, request, limit);
    if (fitting == 0) return smaller;
    text = fmt::format("search at most {} disparities (--disparities {}:{}), ", fitting,
                       range.begin, range.begin + fitting - 1);
  }
  if (!plan.estimated) text += "take a pyramid pipeline (tmgm16), ";
  return text + "or " + smaller;
}

}  // namespace

std::string bytes_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6)
                     : fmt::format("{:.2f} GB", bytes / 1e9);
}

void guard_memory(const Pipeline& pipeline, const MatchRequest& match, const PlanRequest& request,
                  std::optional<double> limit) {
  const std::uint64_t available = available_memory();
  const double free = static_cast<double>(available) + static_cast<double>(resident_memory());
  limit_memory(available);
  if (!limit && usual_bytes(request.load) <= free) return;
  const RunTrace trace = RunTrace::of_reduced(pipeline, match, request.load.threads);
  const RunPlan plan = plan_run(trace, request);
  if (plan.peak_bytes <= limit.value_or(free)) return;
  const std::string needed =
      fmt::format("{} x {} px with {} disparities take {} {}", request.load.size.width,
                  request.load.size.height, request.load.range.size(),
                  plan.estimated ? "about" : "up to", bytes_text(plan.peak_bytes));
  const std::string what_helps = remedy(trace, request, plan, limit.value_or(free));
  if (limit) {
    throw UsageError(needed + ", and --memory-limit allows " + bytes_text(*limit) + "; " +
                     what_helps + ", or raise the limit");
  }
  spdlog::warn("{}, and {} are free; if memory runs out, {}", needed, bytes_text(free), what_helps);
}

}  // namespace xgm::cli
