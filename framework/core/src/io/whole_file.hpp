// SPDX-License-Identifier: Apache-2.0
// Whether a file is as long as it says. OpenCV fills up what is missing of a JPEG, does not notice
// what is too much of a PGM, and lets libpng print.
#pragma once

#include <cstdint>
#include <string>

namespace xgm {

/// Throws Error if an image is cut short (JPEG, PNG, PNM), if the data of a JPEG are damaged, or if
/// a PNM goes on behind its pixels. What follows the end of a JPEG or PNG is no fault: cameras
/// append previews. Other formats are left to their decoders, which refuse what is cut short.
/// `head` are the first bytes of the file.
void require_whole(const std::string& file, const std::string& head);

/// Throws Error unless there are as many bytes as the header says.
void require_length(const std::string& file, std::uint64_t bytes, std::uint64_t needed);

/// The parts of require_whole.
void require_whole_jpeg(const std::string& file);
void require_whole_png(const std::string& file);
void require_whole_pnm(const std::string& file);

}  // namespace xgm
