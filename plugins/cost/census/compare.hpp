// SPDX-License-Identifier: Apache-2.0
// Pixels of a row against eight of their neighbours: the inner loop of the census transform.
#pragma once

#include <array>
#include <cstdint>

namespace xgm::census {

/// Eight neighbours of pixel 0; those of the next pixel are the next elements.
using Neighbours = std::array<const float*, 8>;

/// Writes a byte per pixel: bit k says whether neighbour k is darker than the centre. The next
/// pixel's is the next byte; mirrored, it is the one before.
void compare(const Neighbours& neighbours, const float* centres, int count, bool mirrored,
             std::uint8_t* bytes);

/// The same from pixel `first` on, without vector instructions.
void compare_plain(const Neighbours& neighbours, const float* centres, int first, int count,
                   bool mirrored, std::uint8_t* bytes);

}  // namespace xgm::census
