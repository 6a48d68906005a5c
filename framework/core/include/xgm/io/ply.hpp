// SPDX-License-Identifier: Apache-2.0
// Tables of points: the vertices of PLY files (Turk: The PLY polygon file format, Stanford 1994).
#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
};

struct PlyHeader {
  std::vector<std::string> comments{};    ///< one line each, without the word "comment"
  std::vector<PlyProperty> properties{};  ///< of a vertex, in their order
  std::uint64_t count = 0;                ///< vertices
};

/// Takes the values of a vertex, one for each property. Whole numbers are rounded, and stay within
/// their type; NaN becomes 0 in them.
using PutVertex = std::function<void(std::span<const double>)>;

/// Writes a binary little-endian PLY, vertex by vertex as `vertices` puts them; nothing is held in
/// memory. The file is complete or absent. Throws Error, also if not all are put that the header
/// announces.
XGM_API void write_ply(const std::string& file, const PlyHeader& header,
                       const std::function<void(const PutVertex& put)>& vertices);

/// Reads the vertices of a PLY one after the other, binary little-endian or ASCII. What follows
/// them, such as faces, is left alone.
class XGM_API PlyReader {
 public:
  /// Reads the header. Throws Error, which names the file, and the line if one is wrong: not PLY,
  /// big-endian, vertices that are not the first element or hold lists, and a binary file that is
  /// shorter than its vertices.
  explicit PlyReader(const std::string& file);

  const PlyHeader& header() const { return header_; }
  /// The values of the next vertex, one for each property; false behind the last one. Throws Error
  /// if an ASCII file ends early or holds what is no number.
  bool next(std::span<double> values);

 private:
  [[noreturn]] void fail(const std::string& what) const;
  void read_header(std::string_view text);
  void read_line(std::string_view line, std::size_t number);
  void add_property(const std::vector<std::string>& words, const std::string& place);
  void require_body(std::uint64_t bytes) const;

  std::string file_;
  PlyHeader header_;
  bool is_ascii_ = false, has_format_ = false, in_vertices_ = false, has_vertices_ = false;
  std::uint64_t read_ = 0;  ///< vertices
  std::ifstream stream_;
};

}  // namespace xgm
