// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/run/plan_surface.hpp"

#include <algorithm>
#include <utility>

#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/evaluation/plan_json.hpp"

namespace xgm::geo {
namespace {

// Of each pixel of each window: a point in a cloud, and what is kept to explain empty cells.
constexpr double kPoint = 33;
constexpr double kSeen = 6;
// While a cloud grows, its largest array is there twice.
constexpr double kGrowth = 24;
// Of each pixel of the window that is triangulated: images, range, map, points.
constexpr double kTriangulated = 10 + 8 + 5 + 32;
// Of each point while the layers are made: a copy of it, its cell, and its value among those of its
// cell.
constexpr double kInLayers = 24 + 8 + 8;
// Of each cell: the surface of a pair; and all layers, with where its values begin and end.
constexpr double kSurfaceOfPair = 4, kLayers = 4 * 4 + 3 + 2 * 8;

/// The stereo pipeline inside, with all its parameters.
Pipeline matching_of(const Pipeline& pipeline, const Registry& registry) {
  const Json resolved = Json::parse(pipeline.resolved_json());
  LoadedPipeline loaded =
      load_pipeline_text(resolved.at("matching").dump(), pipeline.file(), registry);
  if (!loaded.pipeline) throw Error(pipeline.file() + ": 'matching' cannot be run alone");
  return *std::move(loaded.pipeline);
}

/// Bytes of all points, and of what is kept to explain empty cells.
double kept_bytes(const std::vector<WorkAhead::Window>& windows) {
  double bytes = 0;
  for (const WorkAhead::Window& window : windows) {
    bytes += kPoint * window.shown.area() + kSeen * window.size.area();
  }
  return bytes;
}

/// What this process holds in its heap now, the request's own pixels aside: key points, metadata
/// and caches of files, which a run holds, too.
double held_now(const MatchRequest& request) {
  trim_heap();
  const ImagePair& pair = request.pair;
  const double request_bytes =
      static_cast<double>(pair.size().area()) *
      (sizeof(float) * 2 * static_cast<double>(pair.base.planes.size()) + 2 + sizeof(Interval));
  return std::max(0.0, static_cast<double>(resident_memory() - program_memory()) - request_bytes);
}

WorkAhead look_ahead(const Pipeline& pipeline, const SurfaceFiles& files,
                     const RunOptions& options) {
  const auto* const family = dynamic_cast<const SurfaceFamily*>(&pipeline.family());
  if (family == nullptr) throw UsageError(pipeline.file() + ": is no pipeline of type surface");
  const SurfaceRequest request = read_surface_request(files);
  WorkAhead ahead;
  pipeline.in_run(options,
                  [&](const Context& context) { ahead = family->look_ahead(request, context); });
  return ahead;
}

}  // namespace

SurfacePlan plan_surface(const Pipeline& pipeline, const Registry& registry,
                         const SurfaceFiles& files, const RunOptions& options) {
  const WorkAhead ahead = look_ahead(pipeline, files, options);
  // Key points may take more than all that follows; they have been looked for already.
  const auto reached = static_cast<double>(peak_memory());
  const double held = held_now(*ahead.largest);
  SurfacePlan plan;
  plan.pairs = ahead.pairs;
  plan.windows = ahead.windows.size();
  for (const WorkAhead::Window& window : ahead.windows) plan.cells += window.cells;
  const int threads = options.threads > 0 ? options.threads : thread_count();
  const double largest = static_cast<double>(ahead.largest->pair.size().area());
  const double kept = kept_bytes(ahead.windows), of_largest = (kPoint + kSeen) * largest;
  const double growth = kGrowth / kPoint * kept / static_cast<double>(ahead.pairs);
  // As if the largest window were the last: the points of all others are there.
  plan.largest = {.load = workload_of(*ahead.largest, threads),
                  .besides = {.after = kTriangulated * largest + of_largest + growth,
                              .held = held + std::max(0.0, kept - of_largest)}};
  const Pipeline matching = matching_of(pipeline, registry);
  plan.matching = plan_run(RunTrace::of_reduced(matching, *ahead.largest, options), plan.largest);
  plan.peak_bytes = plan.matching.peak_bytes;
  plan.peak_stage = plan.matching.peak_stage;
  plan.matching_seconds =
      plan.matching.seconds * plan.cells / std::max(plan.largest.load.cells(), 1.0);
  const double surface =
      static_cast<double>(program_memory()) + held + kept + kInLayers / kPoint * kept +
      (kSurfaceOfPair * static_cast<double>(plan.pairs) + kLayers) * ahead.surface_cells;
  for (const auto& [bytes, stage] : {std::pair{surface, "surface"}, {reached, "pointing"}}) {
    if (bytes <= plan.peak_bytes) continue;
    plan.peak_bytes = bytes;
    plan.peak_stage = stage;
  }
  return plan;
}

std::string to_json(const SurfacePlan& plan) {
  Json json;
  json["pairs"] = plan.pairs;
  json["windows"] = plan.windows;
  json["cells"] = plan.cells;
  json["peak_bytes"] = plan.peak_bytes;
  json["peak_stage"] = plan.peak_stage;
  json["matching_seconds"] = plan.matching_seconds;
  json["largest_window"] = Json::parse(xgm::to_json(plan.matching, plan.largest));
  return json.dump(2) + "\n";
}

}  // namespace xgm::geo
