// SPDX-License-Identifier: Apache-2.0
#include "requests.hpp"

#include <pybind11/stl.h>

#include <utility>

#include "arrays.hpp"
#include "bindings.hpp"
#include "registry.hpp"
#include "xgm/base/error.hpp"
#include "xgm/synthesis/plain_scene.hpp"

namespace xgm::python {
namespace {

DisparityRange to_ranges(const py::array& min, const py::array& max) {
  return range_of_maps({to_map(min), "range_maps[0]"}, {to_map(max), "range_maps[1]"});
}

Request of_arrays(const ArrayImage& left, const ArrayImage& right, bool is_rgb,
                  const ArrayTruth& truth) {
  ReadPair read = to_pair(to_unscaled("left", left, is_rgb), to_unscaled("right", right, is_rgb));
  Request request;
  request.scene.scene = Scene{.name = "arrays",
                              .pair = std::move(read.pair),
                              .truth = to_truth(truth),
                              .notes = std::move(read.notes),
                              .warnings = std::move(read.warnings)};
  request.kept = {left.pixels, right.pixels};
  for (const auto& array : {truth.disparity, truth.non_occluded, truth.objects}) {
    if (array) request.kept.emplace_back(*array);
  }
  return request;
}

Request of_files(const std::string& left, const std::string& right, const std::string& left_mask,
                 const std::string& right_mask, const std::string& truth,
                 std::optional<double> truth_divisor) {
  Request request;
  request.scene.scene = SceneFiles{
      .name = left,
      .images = {.left = left, .right = right, .left_mask = left_mask, .right_mask = right_mask}};
  if (!truth.empty()) {
    request.scene.truth = TruthFiles{.disparity = {truth, truth_divisor.value_or(0)}};
  }
  return request;
}

Request of_scene(const std::string& folder, const std::string& name, const std::string& dataset) {
  return {.scene = {.scene = find_scene(folder, registry(), name, dataset)}};
}

Request of_sample() { return {.scene = {.scene = synthesis::sample_scene()}}; }

/// An array that owns its pixels, for programs that look at what will be matched.
std::vector<py::object> planes_of(const Request& request) {
  std::vector<py::object> planes;
  if (const auto* scene = std::get_if<Scene>(&request.scene.scene)) {
    for (const cv::Mat1f& plane : scene->pair.base.planes) planes.push_back(to_array(plane, false));
  }
  return planes;
}

}  // namespace

UnscaledImage to_unscaled(const std::string& name, const ArrayImage& image, bool is_rgb) {
  UnscaledImage raster = xgm::to_unscaled(name, to_matrix(image.pixels));
  if (is_rgb && raster.planes.size() == 3) std::swap(raster.planes[0], raster.planes[2]);
  if (image.usable) apply_mask(raster, to_mask(image.usable));
  return raster;
}

GroundTruth to_truth(const ArrayTruth& truth) {
  return {.disparity = to_map(truth.disparity),
          .non_occluded = to_mask(truth.non_occluded),
          .objects = to_mask(truth.objects)};
}

std::optional<Interval> to_interval(const std::optional<Range>& range) {
  if (!range) return std::nullopt;
  return Interval{range->first, range->second};
}

void bind_requests(py::module_& module) {
  py::class_<ArrayImage>(module, "ArrayImage")
      .def(py::init([](py::array pixels, std::optional<py::array> usable) {
        return ArrayImage{std::move(pixels), std::move(usable)};
      }));
  py::class_<ArrayTruth>(module, "ArrayTruth")
      .def(py::init([](std::optional<py::array> disparity, std::optional<py::array> non_occluded,
                       std::optional<py::array> objects) {
        return ArrayTruth{std::move(disparity), std::move(non_occluded), std::move(objects)};
      }));
  py::class_<Request>(module, "Request")
      .def("search",
           [](Request& request, Range range) { request.scene.disparities = to_interval(range); })
      .def("search_maps",
           [](Request& request, const std::string& min, const std::string& max) {
             request.scene.range_maps = RangeMapFiles{.min = min, .max = max};
           })
      .def("search_ranges",
           [](Request& request, const py::array& min, const py::array& max) {
             request.scene.ranges = to_ranges(min, max);
           })
      .def("limit_memory",
           [](Request& request, double bytes) { request.scene.memory_limit = bytes; })
      .def("left_planes", &planes_of);
  module.def("request_of_arrays", &of_arrays);
  module.def("request_of_files", &of_files);
  module.def("request_of_scene", &of_scene);
  module.def("request_of_sample", &of_sample);
}

}  // namespace xgm::python
