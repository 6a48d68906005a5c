// SPDX-License-Identifier: Apache-2.0
#include "registry.hpp"

#include <pybind11/stl.h>

#include <cstdlib>
#include <optional>
#include <tuple>

#include "bindings.hpp"
#include "xgm/base/error.hpp"
#ifdef XGM_HAS_GEO
#include "xgm/geo/registry.hpp"
#endif
#include "xgm/pipeline/describe.hpp"
#include "xgm/pipeline/installation.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm::python {
namespace py = pybind11;

Registry& registry() {
  // Never destroyed: what it holds of Python would outlive the interpreter.
  static Registry& registry = *[] {
    auto* const made = new Registry(Registry::with_builtins());
    if (const char* paths = std::getenv("XGM_PLUGIN_PATH")) made->load_path(paths);
    made->load_path(plugins_folder());
#ifdef XGM_HAS_GEO
    geo::add_geo(*made);
#endif
    return made;
  }();
  return registry;
}

std::vector<Override> to_overrides(const Changes& changes) {
  std::vector<Override> overrides;
  for (const auto& [path, value] : changes) overrides.push_back({path, value});
  return overrides;
}

namespace {

using Located = std::tuple<std::string, int, int, std::string, std::string>;
using Loaded = std::pair<std::optional<Pipeline>, std::vector<Located>>;

Loaded to_python(LoadedPipeline loaded) {
  std::vector<Located> diagnostics;
  for (const auto& [where, message, remedy] : loaded.diagnostics) {
    diagnostics.emplace_back(where.file, where.line, where.column, message, remedy);
  }
  return {std::move(loaded.pipeline), std::move(diagnostics)};
}

void load_plugin(const std::string& file) {
  if (!registry().load(file)) throw Error(file + ": " + registry().failures().back().reason);
}

std::vector<std::tuple<std::string, std::string, std::string>> list_plugins(
    const std::string& kind) {
  if (!kind.empty()) require_kind(kind, registry());
  std::vector<std::tuple<std::string, std::string, std::string>> found;
  for (const PluginInfo* plugin : registry().plugins(kind)) {
    found.emplace_back(plugin->kind, plugin->name, plugin->summary);
  }
  return found;
}

std::vector<std::pair<std::string, std::string>> failures() {
  std::vector<std::pair<std::string, std::string>> found;
  for (const LoadFailure& failure : registry().failures()) {
    found.emplace_back(failure.file, failure.reason);
  }
  return found;
}

std::optional<std::pair<int, int>> disparities_of(const Pipeline& pipeline) {
  const auto searched = pipeline.disparities();
  if (!searched) return std::nullopt;
  return std::pair(searched->begin, searched->end);
}

}  // namespace

void bind_registry(py::module_& module) {
  py::class_<Pipeline>(module, "Pipeline")
      .def_property_readonly("file", &Pipeline::file)
      .def("resolved_json", &Pipeline::resolved_json)
      .def("graph", &Pipeline::graph)
      .def("disparities", &disparities_of);
  module.def("load", [](const std::string& name, const Changes& changes) {
    return to_python(load_pipeline(find_pipeline(name), registry(), to_overrides(changes)));
  });
  module.def("load_text",
             [](const std::string& text, const std::string& name, const Changes& changes) {
               return to_python(load_pipeline_text(text, name, registry(), to_overrides(changes)));
             });
  module.def("load_plugin", &load_plugin);
  module.def("failures", &failures);
  module.def("pipelines", [] { return shipped_pipelines(); });
  module.def("plugins", &list_plugins);
  module.def("describe", [](const std::string& name) {
    std::string text;
    for (const PluginInfo* plugin : find_plugins(name, registry())) {
      text += (text.empty() ? "" : "\n") + describe_text(*plugin);
    }
    return text;
  });
  module.def("schema", [] { return pipeline_schema(registry()); });
}

}  // namespace xgm::python
