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

/// The same, by the header of a PNG or BMP that begins with `head`. Of other files: nothing.
void require_possible_header(const std::string& file, const std::string& head);
/// So many first bytes are needed for it; they hold sizes and depth.
inline constexpr std::size_t kSizeHeader = 30;

}  // namespace xgm
