// SPDX-License-Identifier: Apache-2.0
#include "arrays.hpp"

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "xgm/base/error.hpp"

namespace xgm::python {
namespace {

py::dtype dtype_of(int depth) {
  switch (depth) {
    case CV_8U:
      return py::dtype::of<std::uint8_t>();
    case CV_16U:
      return py::dtype::of<std::uint16_t>();
    case CV_16S:
      return py::dtype::of<std::int16_t>();
    case CV_32F:
      return py::dtype::of<float>();
    default:
      throw std::invalid_argument("no array is made of matrices of this type");
  }
}

int depth_of(const py::dtype& dtype) {
  const char kind = dtype.kind();
  const auto bytes = dtype.itemsize();
  if ((kind == 'u' || kind == 'b') && bytes == 1) return CV_8U;
  if (kind == 'u' && bytes == 2) return CV_16U;
  if (kind == 'f' && bytes == 4) return CV_32F;
  if (kind == 'f' && bytes == 8) return CV_64F;
  throw std::invalid_argument("an array of another type than uint8, uint16, float32 and float64");
}

}  // namespace

py::object to_array(const cv::Mat& matrix, bool writeable) {
  if (matrix.empty()) return py::none();
  std::vector<py::ssize_t> shape{matrix.rows, matrix.cols};
  std::vector<py::ssize_t> strides{static_cast<py::ssize_t>(matrix.step[0]),
                                   static_cast<py::ssize_t>(matrix.elemSize())};
  if (matrix.channels() > 1) {
    shape.push_back(matrix.channels());
    strides.push_back(static_cast<py::ssize_t>(matrix.elemSize1()));
  }
  const py::capsule owner(new cv::Mat(matrix), [](void* held) {
    delete static_cast<cv::Mat*>(held);  // NOLINT(cppcoreguidelines-owning-memory)
  });
  py::array array(dtype_of(matrix.depth()), shape, strides, matrix.data, owner);
  if (!writeable) array.attr("setflags")(py::arg("write") = false);
  return array;
}

cv::Mat to_matrix(const py::array& array) {
  const auto axes = array.ndim();
  const int channels = axes == 3 ? static_cast<int>(array.shape(2)) : 1;
  const auto item = array.itemsize();
  const bool is_laid_out = (axes == 2 || axes == 3) && channels >= 1 && channels <= 4 &&
                           array.strides(1) == item * channels &&
                           (axes == 2 || array.strides(2) == item) &&
                           array.strides(0) >= array.shape(1) * item * channels;
  if (!is_laid_out) throw std::invalid_argument("an array whose rows are not contiguous");
  // cv::Mat knows no memory that must not be written to; no caller writes to it.
  return {static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1)),
          CV_MAKETYPE(depth_of(array.dtype()), channels), const_cast<void*>(array.data()),
          static_cast<std::size_t>(array.strides(0))};
}

cv::Mat1f to_map(const std::optional<py::array>& array) {
  if (!array) return {};
  const cv::Mat matrix = to_matrix(*array);
  if (matrix.type() != CV_32FC1) throw std::invalid_argument("a map of another type than float32");
  return matrix;
}

cv::Mat1b to_mask(const std::optional<py::array>& array) {
  if (!array) return {};
  const cv::Mat matrix = to_matrix(*array);
  if (matrix.type() != CV_8UC1) throw std::invalid_argument("a mask of another type than uint8");
  return array->dtype().kind() == 'b' ? cv::Mat1b(matrix != 0) : cv::Mat1b(matrix);
}

py::bytes to_png(const cv::Mat3b& picture) {
  std::vector<unsigned char> bytes;
  cv::imencode(".png", picture, bytes);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

DisparityMap to_disparity_map(const py::array& disparity, const py::array& status) {
  DisparityMap map;
  map.disparity = to_map(disparity);
  map.status = to_mask(status);
  if (map.disparity.size() != map.status.size()) {
    throw UsageError("disparities and statuses differ in size; give both of one map");
  }
  return map;
}

}  // namespace xgm::python
