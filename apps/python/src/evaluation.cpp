// SPDX-License-Identifier: Apache-2.0
// Maps compared with truth, pictures of maps, and generated scenes.
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "requests.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/evaluation/evaluation_json.hpp"
#include "xgm/evaluation/truth_doubts.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/synthesis/plain_scene.hpp"

namespace xgm::python {
namespace {

std::pair<std::string, std::vector<std::string>> judge(
    const py::array& disparity, const py::array& status, const ArrayTruth& truth,
    const std::vector<double>& thresholds, double scale, const std::optional<Range>& clip) {
  const DisparityMap map = to_disparity_map(disparity, status);
  const GroundTruth known = to_truth(truth);
  const EvaluationRules rules{thresholds, scale, to_interval(clip).value_or(Interval{})};
  const py::gil_scoped_release release;
  const Json figures = to_json(evaluate_regions(map, known, rules));
  return {figures.dump(), truth_doubts(map, known.disparity, {})};
}

/// What a camera would have stored: (height, width), or with a third axis red, green, blue.
py::object stored_levels(const Image& image, int bits) {
  std::vector<cv::Mat1f> planes(image.planes.rbegin(), image.planes.rend());
  cv::Mat levels;
  cv::merge(planes, levels);
  if (bits == 0) return to_array(levels);
  cv::Mat stored;
  levels.convertTo(stored, bits == 16 ? CV_16U : CV_8U, bits == 16 ? 65535.0 / 255.0 : 1.0);
  return to_array(stored);
}

struct Generated {
  synthesis::GeneratedScene scene;
  synthesis::Options options;
};

Generated generate(std::pair<int, int> size, Range disparities, std::uint64_t seed, int objects,
                   bool colour, int bits, const std::vector<std::string>& faults, int threads) {
  synthesis::Options options;
  options.size = {size.first, size.second};
  options.disparities = {disparities.first, disparities.second};
  options.seed = seed;
  options.objects = objects;
  options.colour = colour;
  options.bits = bits;
  for (const std::string& fault : faults) synthesis::plant(options.faults, fault);
  const py::gil_scoped_release release;
  const ThreadLimit limit(threads);
  return {synthesis::generate(options), options};
}

Generated sample() {
  synthesis::Options options;
  options.content = synthesis::Content::plain;
  return {synthesis::sample_pair(), options};
}

void bind_generated(py::module_& module) {
  py::class_<Generated>(module, "Generated")
      .def("left",
           [](const Generated& made) {
             return stored_levels(made.scene.pair.base, made.options.bits);
           })
      .def("right",
           [](const Generated& made) {
             return stored_levels(made.scene.pair.match, made.options.bits);
           })
      .def("truth", [](const Generated& made) { return to_array(made.scene.truth); })
      .def("reverse_truth",
           [](const Generated& made) { return to_array(made.scene.reverse_truth); })
      .def("non_occluded", [](const Generated& made) { return to_array(made.scene.non_occluded); })
      .def("disparities",
           [](const Generated& made) {
             return Range{made.scene.disparities.begin, made.scene.disparities.end};
           })
      .def("calibration",
           [](const Generated& made) {
             const Calibration& cameras = made.scene.calibration;
             return std::vector<double>{cameras.focal, cameras.cx, cameras.cy, cameras.doffs,
                                        cameras.baseline};
           })
      .def("write", [](const Generated& made, const std::string& folder) {
        synthesis::write_scene(folder, made.scene, made.options);
      });
  module.def("generate", &generate);
  module.def("sample", &sample);
}

}  // namespace

void bind_evaluation(py::module_& module) {
  bind_generated(module);
  module.def("evaluate", &judge);
  module.def("usual_thresholds", &usual_thresholds);
  module.def("disparity_png", [](const py::array& disparity, const py::array& status) {
    return to_png(disparity_picture(to_disparity_map(disparity, status)));
  });
  module.def("status_png", [](const py::array& disparity, const py::array& status) {
    return to_png(status_picture(to_disparity_map(disparity, status)));
  });
  py::list names;
  for (int i = 0; i < kStatusCount; ++i) {
    names.append(std::string(to_string(static_cast<Status>(i))));
  }
  module.attr("statuses") = py::tuple(names);
}

}  // namespace xgm::python
