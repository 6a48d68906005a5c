// SPDX-License-Identifier: Apache-2.0
// What the first bytes of an image file tell: its format, and how large its pixels are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "xgm/base/error.hpp"

namespace xgm {

/// The bytes that the pixels of an image take when they are decoded, as the header of its file
/// states them; 0 for formats whose whole file is looked at before (JPEG, PNM). Nothing if the
/// format is none of PNG, JPEG, PNM, BMP, WebP, JPEG 2000, Sun raster, Radiance and EXR: OpenCV may
/// still find a decoder for such a file, which guesses.
std::optional<std::uint64_t> stated_bytes(std::string_view head);

/// So many first bytes are needed for it.
inline constexpr std::size_t kImageHead = 4096;

/// P1 to P7 and white space, or a comment.
bool is_pnm(std::string_view head);

/// What to throw if a file is none of these, or cannot be decoded.
Error no_image(const std::string& file);

}  // namespace xgm
