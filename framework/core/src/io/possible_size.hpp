// SPDX-License-Identifier: Apache-2.0
// Whether an image can be as large as its header says, asked before memory is taken for it.
#pragma once

#include <cstdint>
#include <string>

namespace xgm {

/// False if the decoded image would be large, and many times larger than codecs make of a file of
/// this size.
bool is_possible_size(std::uint64_t file_bytes, std::uint64_t image_bytes);

/// Throws Error unless it is possible.
void require_possible_size(const std::string& file, std::uint64_t image_bytes);

/// The same, by the header of a file of any format but TIFF and PFM, which begins with `head`.
/// Throws Error too if it is no image: what OpenCV makes of such a file is a guess.
void require_possible_header(const std::string& file, const std::string& head);

}  // namespace xgm
