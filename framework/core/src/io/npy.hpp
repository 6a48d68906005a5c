// SPDX-License-Identifier: Apache-2.0
// NumPy's file format. Some of it is exported, for the tests only.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/volume.hpp"

namespace xgm {

/// Shape (height, width, hull of all ranges); cells outside a pixel's range are kNoMatch. Written
/// row by row: no dense copy is ever held. Throws Error.
void write_npy(const std::string& file, const Volume<std::uint8_t>& volume);
void write_npy(const std::string& file, const Volume<std::uint16_t>& volume);

/// Shape (height, width), or (height, width, channels); 8-bit numbers, 32-bit whole ones or floats.
/// Throws Error.
XGM_API void write_npy(const std::string& file, const cv::Mat& matrix);

/// An array of a file, in the order of C. Numbers are of this machine's byte order.
struct NpyArray {
  std::string type;  ///< "u1", "f4" or "f8"
  std::vector<std::size_t> shape;
  std::string bytes;  ///< of the whole file
  std::size_t begin;  ///< of the elements in it

  /// Element i, whatever the type.
  XGM_API double at(std::size_t i) const;
};

/// "(497, 741)"
std::string shape_text(const std::vector<std::size_t>& shape);

/// Versions 1 to 3 of the format. Throws Error: no such file, one that is cut short or too long,
/// another type or order.
XGM_API NpyArray read_npy(const std::string& file);

}  // namespace xgm
