// SPDX-License-Identifier: Apache-2.0
// From satellite images to a surface.
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "registry.hpp"
#include "watched.hpp"
#include "xgm/base/error.hpp"

#ifdef XGM_HAS_GEO
#include <memory>
#include <string>
#include <vector>

#include "xgm/geo/run/recorded_surface.hpp"
#include "xgm/geo/run/relief.hpp"
#endif

namespace xgm::python {

#ifdef XGM_HAS_GEO
namespace {

struct SurfaceWishes {
  std::string folder{};  ///< "" = nothing is written
  std::string geoid{};
  Changes changes{};  ///< that the pipeline was loaded with
  int threads = 0;
};

using SharedSurface = std::shared_ptr<geo::RecordedSurface>;

SharedSurface run_surface(const Pipeline& pipeline, const geo::SurfaceFiles& files,
                          const std::string& scene, const SurfaceWishes& wishes,
                          const Hooks& hooks) {
  geo::SurfaceRecordRequest request{.folder = wishes.folder,
                                    .geoid = wishes.geoid,
                                    .overrides = to_overrides(wishes.changes),
                                    .command_line = {"python"}};
  if (!scene.empty()) request.inputs.push_back({"scene", scene});
  auto recorded = std::make_shared<geo::RecordedSurface>();
  run_watched(hooks, wishes.threads, [&](const RunOptions& options) {
    *recorded = geo::record_surface(pipeline, files, request, options);
  });
  return recorded;
}

/// As GDAL has it: column and row are those of a corner, 0 is the upper left one.
std::vector<double> geotransform(const geo::RecordedSurface& surface) {
  const geo::GridPlace& place = surface.result.grid.place;
  return {place.left, place.step_x, 0, place.top, 0, place.step_y};
}

std::vector<std::string> reason_names() {
  std::vector<std::string> names;
  for (int i = 0; i < geo::kCellReasonCount; ++i) {
    names.emplace_back(geo::to_string(static_cast<geo::CellReason>(i)));
  }
  return names;
}

void bind_files_of_surface(py::module_& module) {
  py::class_<geo::SurfaceFiles>(module, "SurfaceFiles")
      .def(py::init<>())
      .def_readwrite("images", &geo::SurfaceFiles::images)
      .def_readwrite("dem", &geo::SurfaceFiles::dem)
      .def_readwrite("masks", &geo::SurfaceFiles::masks)
      .def_readwrite("cameras", &geo::SurfaceFiles::cameras)
      .def_readwrite("area", &geo::SurfaceFiles::area)
      .def_readwrite("band", &geo::SurfaceFiles::band)
      .def_readwrite("clouds", &geo::SurfaceFiles::clouds)
      .def_readwrite("truth", &geo::SurfaceFiles::truth);
  module.def("read_surface_scene", &geo::read_surface_scene);
  py::class_<SurfaceWishes>(module, "SurfaceWishes")
      .def(py::init<>())
      .def_readwrite("folder", &SurfaceWishes::folder)
      .def_readwrite("geoid", &SurfaceWishes::geoid)
      .def_readwrite("changes", &SurfaceWishes::changes)
      .def_readwrite("threads", &SurfaceWishes::threads);
}

template <class Layer>
auto layer(Layer show) {
  return [show](const geo::RecordedSurface& surface) { return to_array(show(surface.result)); };
}

void bind_surface(py::module_& module) {
  using Result = geo::SurfaceResult;
  py::class_<geo::RecordedSurface, SharedSurface>(module, "RecordedSurface")
      .def("heights", layer([](const Result& r) { return r.fused.heights.values; }))
      .def("pairs", layer([](const Result& r) { return r.fused.count; }))
      .def("spread", layer([](const Result& r) { return r.fused.spread; }))
      .def("gap", layer([](const Result& r) { return r.gaps; }))
      .def("source", layer([](const Result& r) { return r.sources; }))
      .def("reasons", layer([](const Result& r) { return r.reasons; }))
      .def("orthoimage", layer([](const Result& r) { return r.orthoimage.values; }))
      .def("geotransform", &geotransform)
      .def("crs", [](const geo::RecordedSurface& s) { return s.result.grid.crs; })
      .def("picture",
           [](const geo::RecordedSurface& s) {
             return to_png(geo::relief_picture(s.result.fused.heights));
           })
      .def_readonly("record_json", &geo::RecordedSurface::record)
      .def_readonly("covered", &geo::RecordedSurface::covered)
      .def_readonly("seconds", &geo::RecordedSurface::seconds)
      .def_readonly("failure", &geo::RecordedSurface::failure)
      .def_readonly("warnings", &geo::RecordedSurface::warnings);
}

}  // namespace

void bind_surfaces(py::module_& module) {
  bind_files_of_surface(module);
  bind_surface(module);
  module.def("run_surface", &run_surface);
  module.attr("reasons") = py::tuple(py::cast(reason_names()));
}
#else
// The package says what is missing.
void bind_surfaces(py::module_&) {}
#endif

}  // namespace xgm::python
