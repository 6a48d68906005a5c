// SPDX-License-Identifier: Apache-2.0
// Walks along the lines of a band and extends all paths at each pixel: the hot loop of the engine.
#pragma once

#include "plugins/aggregation/path_engine/pass_walk.hpp"

namespace xgm::aggregation {

/// The lines of a band. Line i is i * lag pixels behind the first line.
template <class Cell>
struct Band {
  WalkedLine<Cell> lines[kBand];
  int count;
};

/// Walks pixels `first` to `last` - 1 of the band's first line, and as many pixels of each other
/// line. Pixels outside a line are skipped. At each pixel and for each path:
///   L = C + message, and S += message.
/// The message of a path with two terms is their mean in whole units, halves rounded to even: if
/// they were always rounded up or always down, the errors would add up.
template <class Cell>
using Advance = void (*)(PassWalk<Cell>& walk, Band<Cell>& band, int first, int last);

/// The fastest implementation for this pass and the SIMD target in use.
template <class Cell>
Advance<Cell> choose_advance(const PassStep& pass);

/// Extends the paths at element k of the line's layout, cell by cell. Works for every pass, and is
/// the reference for all other implementations.
template <class Cell>
void extend_plain(const PassWalk<Cell>& walk, WalkedLine<Cell>& line, int k);

}  // namespace xgm::aggregation
