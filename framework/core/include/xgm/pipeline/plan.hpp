// SPDX-License-Identifier: Apache-2.0
// What a run will take, told before it begins: a small run of the same pipeline is watched, and
// what its stages were given, returned and took is scaled to the size asked for.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/pipeline/pipeline.hpp"
#include "xgm/stage/needs.hpp"
#include "xgm/stage/place.hpp"

namespace xgm {

/// What a finer level of a pyramid searches: `spread + lost * D` cells per pixel, of the D
/// disparities of its limits. Most pixels search around what the coarser level found, whatever the
/// scale; a share of them has lost its disparity and searches everything.
struct Narrowing {
  double spread = 0;
  double lost = 0;
};

/// What was seen of a small run. Refers to the pipeline's stages, and holds none of its pixels.
class XGM_API RunTrace {
 public:
  /// Runs the pipeline twice, with the options' resources and without their observer, on a pair
  /// that is several times smaller than `request`'s: 0.1 to 0.4 megapixels. Throws Error and
  /// Cancelled as a run does.
  static RunTrace of_reduced(const Pipeline& pipeline, const MatchRequest& request,
                             const RunOptions& options = {});
  /// The same with this pair as it is.
  static RunTrace of_whole(const Pipeline& pipeline, const MatchRequest& request,
                           const RunOptions& options = {});

  /// Like of_reduced(), for plans of memory: runs once and measures no bandwidth, which would take
  /// more memory than small runs do. Seconds of such plans mean little.
  static RunTrace of_memory(const Pipeline& pipeline, const MatchRequest& request,
                            const RunOptions& options = {});

  /// Of the scene; none without a pyramid. May be replaced by what is known better.
  std::optional<Narrowing> narrowing;

  struct Calls;
  const Calls& calls() const { return *calls_; }

 private:
  /// Watches one run.
  static std::shared_ptr<Calls> watch(const Pipeline& pipeline, const MatchRequest& request,
                                      RunOptions options);
  explicit RunTrace(std::shared_ptr<const Calls> calls);
  std::shared_ptr<const Calls> calls_;
};

/// One call of one stage, in the order in which they will begin.
struct PlannedStage {
  StagePlace place;
  Workload load;
  Needs needs{};       ///< of the stage alone
  double memory = 0;   ///< bytes that the whole process holds at most while the stage runs
  double seconds = 0;  ///< of the stage alone
  /// Path of the stage whose result it is going to be given, instead of running; else empty.
  std::string same_as{};
};

/// Bytes that the caller of a run takes beside it.
struct Besides {
  double level_pixel = 0;  ///< kept of each pixel of each level of a pyramid, until the end
  double after = 0;        ///< taken when the maps are there, to write files
  double held = 0;         ///< from the beginning to the end
  /// Whether the volumes' memory is kept after the matcher (BufferReuse), for the next map.
  bool volumes_stay = false;
};

struct PlanRequest {
  Workload load;       ///< of the whole pair
  bool truth = false;  ///< whether maps of truth are held, too
  Besides besides{};
};

struct RunPlan {
  std::vector<PlannedStage> stages;
  double peak_bytes = 0;   ///< of the process, see peak_memory()
  std::string peak_stage;  ///< path of the stage, innermost, in which the most is in use
  double seconds = 0;      ///< of matching
  bool estimated = false;  ///< whether the peak depends on a guess of what a pyramid searches
  std::optional<Narrowing> narrowing{};
};

/// The question that a run asks of a pipeline, in numbers.
XGM_API Workload workload_of(const MatchRequest& request, int threads);
/// The same of images that are not held; `valid` of the base image may be empty.
XGM_API Workload workload_of(const DisparityRange& range, int planes, const cv::Mat1b& valid,
                             int threads);

/// Runs nothing: the trace scaled to the request.
XGM_API RunPlan plan_run(const RunTrace& trace, const PlanRequest& request);

/// How many disparities, from the first one of `request` on, can be searched in so many bytes; as
/// many as are asked for at most, 0 if none.
XGM_API int max_disparities(const RunTrace& trace, PlanRequest request, double bytes);

/// What a run takes at least and what it hardly exceeds if it is an ordinary one, without watching
/// any: whether it is worth to plan it. Bytes of the process.
XGM_API double usual_bytes(const Workload& load);

}  // namespace xgm
