// SPDX-License-Identifier: Apache-2.0
#include "pipeline/memory_guard.hpp"

#include "xgm/base/error.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/text.hpp"

namespace xgm {
namespace {

/// What would make it fit.
std::string remedy(const RunTrace& trace, const PlanRequest& request, const RunPlan& plan,
                   double limit) {
  const int begin = request.load.range.begin;
  const std::string smaller = "match smaller images";
  std::string text = "search fewer disparities, ";
  if (!request.load.ragged) {
    const int fitting = max_disparities(trace, request, limit);
    if (fitting == 0) return smaller;
    text = "search at most " + std::to_string(fitting) + " disparities (--disparities " +
           std::to_string(begin) + ":" + std::to_string(begin + fitting - 1) + "), ";
  }
  if (!plan.estimated) text += "take a pyramid pipeline (tmgm16), ";
  return text + "match in tiles (pipeline run --tiles auto), or " + smaller;
}

std::string text_of(const Workload& load, const RunPlan& plan) {
  return std::to_string(load.size.width) + " x " + std::to_string(load.size.height) + " px with " +
         std::to_string(load.range.size()) + " disparities take " +
         (plan.estimated ? "about " : "up to ") + bytes_text(plan.peak_bytes);
}

}  // namespace

std::string guard_memory(const Pipeline& pipeline, const MatchRequest& match,
                         const PlanRequest& request, std::optional<double> limit,
                         const RunOptions& options) {
  const double free =
      static_cast<double>(available_memory()) + static_cast<double>(resident_memory());
  if (!limit && usual_bytes(request.load) <= free) return {};
  const RunTrace trace = RunTrace::of_memory(pipeline, match, options);
  const RunPlan plan = plan_run(trace, request);
  if (plan.peak_bytes <= limit.value_or(free)) return {};
  const std::string needed = text_of(request.load, plan);
  const std::string what_helps = remedy(trace, request, plan, limit.value_or(free));
  if (limit) {
    throw UsageError(needed + ", and --memory-limit allows " + bytes_text(*limit) + "; " +
                     what_helps + ", or raise the limit");
  }
  return needed + ", and " + bytes_text(free) + " are free; if memory runs out, " + what_helps;
}

}  // namespace xgm
