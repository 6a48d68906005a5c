// SPDX-License-Identifier: Apache-2.0
// What a run will take, told before it begins: memory from what every stage says of itself, seconds
// from a small run of the same pipeline.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/pipeline/pipeline.hpp"
#include "xgm/stage/needs.hpp"

namespace xgm {

/// One call of one stage, in the order in which they will begin.
struct PlannedStage {
  std::string path;  ///< as in the record of a run
  std::string kind;
  std::string plugin;
  Workload load;
  Needs needs{};       ///< updates and moved are those of the stage alone, not of stages inside
  double memory = 0;   ///< bytes that the whole process holds at most while the stage runs
  double seconds = 0;  ///< of the stage alone; 0 if no speed is known
};

/// What a small run of a pipeline tells of a larger one.
struct Experience {
  std::optional<Narrowing> narrowing{};  ///< if the pipeline has a pyramid
  /// Updates per second, by kind and plugin ("aggregation/mgm"), with the threads asked for.
  std::map<std::string, double> speeds{};
  double bandwidth = 0;  ///< bytes per second read and written, with these threads
};

struct PlanRequest {
  Workload load;            ///< of the whole pair
  bool truth = false;       ///< whether maps of truth are held, too
  Experience experience{};  ///< as probe() finds it; without it, what plugins say of themselves
};

struct RunPlan {
  std::vector<PlannedStage> stages;
  double peak_bytes = 0;   ///< of the process, see peak_memory()
  std::string peak_stage;  ///< path of the stage, innermost, in which that is
  double seconds = 0;      ///< of matching; 0 if no speed is known
  bool estimated = false;  ///< whether the peak depends on a guess of what a pyramid searches
};

/// The question that a run asks of a pipeline, in numbers.
XGM_API Workload workload_of(const MatchRequest& request, int threads);

/// Runs the pipeline on a pair that is several times smaller than `request`'s, and measures.
XGM_API Experience probe(const Pipeline& pipeline, const MatchRequest& request, int threads);
/// Runs the pipeline on this pair as it is, and measures.
XGM_API Experience probe_whole(const Pipeline& pipeline, const MatchRequest& request, int threads);

/// Reads no pixel and runs nothing.
XGM_API RunPlan plan_run(const Pipeline& pipeline, const PlanRequest& request);

/// How many disparities, from the first one of `request` on, can be searched in so many bytes; as
/// many as are asked for at most, 0 if none.
XGM_API int max_disparities(const Pipeline& pipeline, PlanRequest request, double bytes);

/// The plan as indented JSON.
XGM_API std::string to_json(const RunPlan& plan, const PlanRequest& request);

}  // namespace xgm
