// SPDX-License-Identifier: Apache-2.0
// numpy arrays and matrices that share their memory.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "xgm/data/disparity_map.hpp"

namespace xgm::python {
namespace py = pybind11;

/// An array that shows the pixels of a matrix and keeps them alive: (height, width), with a third
/// axis if there are several channels. None of an empty matrix.
py::object to_array(const cv::Mat& matrix, bool writeable = true);

/// A matrix that shows the elements of an array of two axes, or three with up to four channels, of
/// type uint8, bool, uint16, float32 or float64; it lives no longer than the array. The elements of
/// a row must lie side by side: the package sees to it. Throws std::invalid_argument else.
cv::Mat to_matrix(const py::array& array);

/// The same, which is of float32 and has one channel; empty without an array.
cv::Mat1f to_map(const std::optional<py::array>& array);
/// The same of uint8, or of bool, whose true becomes 255 in a copy.
cv::Mat1b to_mask(const std::optional<py::array>& array);

/// The bytes of a PNG.
py::bytes to_png(const cv::Mat3b& picture);

/// A map of the same memory. Throws UsageError if the arrays differ in size.
DisparityMap to_disparity_map(const py::array& disparity, const py::array& status);

}  // namespace xgm::python
