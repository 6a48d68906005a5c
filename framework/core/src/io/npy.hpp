// SPDX-License-Identifier: Apache-2.0
// NumPy's file format, version 1.0, for dense volumes.
#pragma once

#include <string>

#include "xgm/data/volume.hpp"

namespace xgm {

/// Shape (height, width, hull of all ranges); cells outside a pixel's range are kNoMatch. Written
/// row by row: no dense copy is ever held. Throws Error.
void write_npy(const std::string& file, const Volume<std::uint8_t>& volume);
void write_npy(const std::string& file, const Volume<std::uint16_t>& volume);

}  // namespace xgm
