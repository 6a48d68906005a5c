// SPDX-License-Identifier: Apache-2.0
// Walks along lines and extends all paths at each of their pixels: where the time goes.
#pragma once

#include "plugins/aggregation/path_engine/pass_walk.hpp"

namespace xgm::aggregation {

/// The lines of a band, line i being i * lag pixels behind the first one.
template <class Cell>
struct Band {
  WalkedLine<Cell> lines[kBand];
  int count;
};

/// Goes on from pixel `first` of the band's first line to before pixel `last`, and as far with the
/// others; what lies outside a line is skipped. At each pixel:
///   L = C + mean of the terms, and S += mean of the terms.
/// Means are rounded to whole units, halves to even: always up or down, errors would add up.
template <class Cell>
using Advance = void (*)(PassWalk<Cell>& walk, Band<Cell>& band, int first, int last);

/// The fastest that takes this pass, for the SIMD target in use.
template <class Cell>
Advance<Cell> choose_advance(const PassStep& pass);

/// The pixel that element k of its line's layout is about, cell by cell, in any pass: the reference
/// of all others.
template <class Cell>
void extend_plain(const PassWalk<Cell>& walk, WalkedLine<Cell>& line, int k);

}  // namespace xgm::aggregation
