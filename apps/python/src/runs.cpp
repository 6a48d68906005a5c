// SPDX-License-Identifier: Apache-2.0
// Matching and explaining.
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "registry.hpp"
#include "requests.hpp"
#include "watched.hpp"
#include "xgm/base/error.hpp"
#include "xgm/evaluation/recorded_run.hpp"
#include "xgm/stage/observers.hpp"
#include "xgm/tiles/in_tiles.hpp"

namespace xgm::python {
namespace {

using Tiles = std::variant<bool, std::pair<int, int>>;  ///< whether, or width and height

/// What a run is asked for beside the images.
struct RunWishes {
  std::string folder{};  ///< "" = nothing is written
  bool report = false;
  std::string dump{}, cloud{}, depth{};
  Changes changes{};  ///< that the pipeline was loaded with
  Tiles tiles = false;
  int threads = 0;
};

ChooseParts parts(const RunWishes& wishes, const Pipeline& pipeline) {
  if (const auto* size = std::get_if<std::pair<int, int>>(&wishes.tiles)) {
    return tiles::in_tiles(pipeline, cv::Size(size->first, size->second));
  }
  if (std::get<bool>(wishes.tiles)) return tiles::in_tiles(pipeline, std::nullopt);
  return {};
}

using SharedRun = std::shared_ptr<RecordedRun>;

SharedRun run(const Pipeline& pipeline, const Request& request, const RunWishes& wishes,
              const Hooks& hooks) {
  const RecordRequest record{.folder = wishes.folder,
                             .overrides = to_overrides(wishes.changes),
                             .command_line = {"python"},
                             .dump = wishes.dump,
                             .report = wishes.report,
                             .depth = {wishes.cloud, wishes.depth},
                             .parts = parts(wishes, pipeline),
                             .holds_maps = true};
  auto result = std::make_shared<RecordedRun>();
  run_watched(hooks, wishes.threads, [&](const RunOptions& options) {
    const auto call = wishes.folder.empty() ? &record_in_memory : &record_scene;
    *result = call(pipeline, request.scene, record, options);
    // They may show memory of arrays that live no longer than this call.
    result->run.scene.pair = {};
    result->run.scene.truth = {};
  });
  return result;
}

std::vector<std::pair<std::string, std::string>> explain(
    const Pipeline& pipeline, const Request& request,
    const std::vector<std::pair<int, int>>& pixels, int threads, const Hooks& hooks) {
  ExplainPixels wanted;
  for (const auto& [x, y] : pixels) wanted.pixels.emplace_back(x, y);
  std::vector<std::pair<std::string, std::string>> explanations;
  run_watched(hooks, threads, [&](RunOptions options) {
    SceneInputs inputs = read_scene(request.scene, pipeline);
    const auto explainer = make_explainer(wanted, inputs.scene);
    Observers observers;
    observers.add(*options.observer);
    observers.add(*explainer);
    options.observer = &observers;
    match_scene(pipeline, std::move(inputs), options);
    for (const Explanation& explanation : explainer->explanations()) {
      explanations.emplace_back(to_text(explanation), to_json(explanation));
    }
  });
  return explanations;
}

const DisparityMap& reverse_of(const RecordedRun& run) {
  static const DisparityMap none;
  return run.run.maps.reverse ? *run.run.maps.reverse : none;
}

void bind_result(py::module_& module) {
  py::class_<RecordedRun, SharedRun>(module, "RecordedRun")
      .def("disparity",
           [](const RecordedRun& run) { return to_array(run.run.maps.forward.disparity); })
      .def("status", [](const RecordedRun& run) { return to_array(run.run.maps.forward.status); })
      .def("confidence",
           [](const RecordedRun& run) { return to_array(run.run.maps.forward.confidence); })
      .def("reverse_confidence",
           [](const RecordedRun& run) { return to_array(reverse_of(run).confidence); })
      .def("reverse_disparity",
           [](const RecordedRun& run) { return to_array(reverse_of(run).disparity); })
      .def("reverse_status",
           [](const RecordedRun& run) { return to_array(reverse_of(run).status); })
      .def("record_json", [](const RecordedRun& run) { return to_json(run.record); })
      .def_property_readonly("failure", [](const RecordedRun& run) { return run.failure; })
      .def_property_readonly("warnings", [](const RecordedRun& run) { return run.record.warnings; })
      .def_property_readonly("seconds",
                             [](const RecordedRun& run) { return run.run.matching_seconds; });
}

}  // namespace

void bind_runs(py::module_& module) {
  bind_result(module);
  py::class_<Hooks>(module, "Hooks")
      .def(py::init([](py::object progress, py::object log, py::object cancelled) {
        return Hooks{std::move(progress), std::move(log), std::move(cancelled)};
      }));
  py::class_<RunWishes>(module, "RunWishes")
      .def(py::init<>())
      .def_readwrite("folder", &RunWishes::folder)
      .def_readwrite("report", &RunWishes::report)
      .def_readwrite("dump", &RunWishes::dump)
      .def_readwrite("cloud", &RunWishes::cloud)
      .def_readwrite("depth", &RunWishes::depth)
      .def_readwrite("changes", &RunWishes::changes)
      .def_readwrite("tiles", &RunWishes::tiles)
      .def_readwrite("threads", &RunWishes::threads);
  module.def("run", &run);
  module.def("explain", &explain);
}

}  // namespace xgm::python
