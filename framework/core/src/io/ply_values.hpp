// SPDX-License-Identifier: Apache-2.0
// Values of PLY files: the names of their types, and their bytes.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "xgm/io/ply.hpp"

namespace xgm {

std::size_t size_of(PlyType type);  ///< bytes
/// "double"
std::string_view name_of(PlyType type);
/// From either of its names: "float", "float32".
std::optional<PlyType> ply_type(std::string_view name);

/// Little-endian, size_of(type) bytes.
double load(const char* bytes, PlyType type);
void store(char* bytes, PlyType type, double value);

}  // namespace xgm
