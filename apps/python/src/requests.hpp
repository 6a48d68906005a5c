// SPDX-License-Identifier: Apache-2.0
// What Python asks to match: arrays, files, or a scene.
#pragma once

#include <pybind11/numpy.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "xgm/data/ground_truth.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/pipeline/scene_inputs.hpp"

namespace xgm::python {
namespace py = pybind11;

/// An image as the package hands it over.
struct ArrayImage {
  py::array pixels;
  std::optional<py::array> usable;  ///< of its size, uint8 or bool: not 0 where it may be used
};

/// `is_rgb`: whether the first of three channels is red, not blue.
UnscaledImage to_unscaled(const std::string& name, const ArrayImage& image, bool is_rgb);

struct ArrayTruth {
  std::optional<py::array> disparity, non_occluded, objects;
};
GroundTruth to_truth(const ArrayTruth& truth);

/// Refers to the memory of the arrays, which it keeps alive.
struct Request {
  SceneRequest scene{};
  std::vector<py::object> kept{};
};

using Range = std::pair<int, int>;  ///< half-open
std::optional<Interval> to_interval(const std::optional<Range>& range);

}  // namespace xgm::python
