// SPDX-License-Identifier: Apache-2.0
#include "plan/plan_surface.hpp"

#include "xgm/base/error.hpp"

#ifdef XGM_HAS_GEO
#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "command_line/command_line.hpp"
#include "terminal/console.hpp"
#include "terminal/observer.hpp"
#include "xgm/base/text.hpp"
#include "xgm/geo/run/plan_surface.hpp"
#endif

namespace xgm::cli {

#ifdef XGM_HAS_GEO
namespace {

void print(const Pipeline& pipeline, const geo::SurfacePlan& plan) {
  const Workload& load = plan.largest.load;
  std::cout << fmt::format(
                   "{}: {} pair{} in {} window{}; the largest {} x {} px, {:.0f} cells/px\n",
                   pipeline.file(), plan.pairs, plan.pairs == 1 ? "" : "s", plan.windows,
                   plan.windows == 1 ? "" : "s", load.size.width, load.size.height,
                   load.cells_per_pixel)
            << "memory: " << bytes_text(plan.peak_bytes) << " at most, in " << plan.peak_stage
            << fmt::format("\ntime:   about {:.1f} s of matching\n", plan.matching_seconds)
            << std::flush;
}

}  // namespace

int plan_surface(const Pipeline& pipeline, const Registry& registry,
                 const SurfaceQuestion& question, int threads) {
  const geo::SurfaceFiles files = surface_files(question.scene, question.files);
  if (files.images.empty()) {
    throw UsageError(pipeline.file() +
                     ": makes surfaces of satellite images; give --images FILE FILE ..., or a "
                     "scene in YAML");
  }
  Progress progress;
  TerminalObserver observer(progress);
  progress.begin("finding what is to be matched");
  const geo::SurfacePlan plan =
      geo::plan_surface(pipeline, registry, files, {.observer = &observer, .threads = threads});
  progress.end();
  if (question.json) {
    std::cout << to_json(plan);
  } else {
    print(pipeline, plan);
  }
  return kOk;
}
#else
int plan_surface(const Pipeline&, const Registry&, const SurfaceQuestion&, int) {
  throw UsageError("this program was built without GDAL and PROJ");
}
#endif

}  // namespace xgm::cli
