// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/shared/run_pass.hpp"

#include <algorithm>

#include "plugins/aggregation/shared/advance.hpp"
#include "xgm/base/parallel.hpp"

namespace xgm::aggregation {

template <class Cell>
void run_pass(PassWalk<Cell>& walk, LineProgress& progress) {
  const Advance<Cell> advance = choose_advance<Cell>(walk.step());
  ExceptionKeeper keeper;
  walk.load_penalties();
  // The last line of a band comes so much later to its end: for the wavefront, a band is a line
  // that is longer.
  const int lines = walk.frame().lines(), lag = walk.lag();
  const int length = walk.frame().length() + (kBand - 1) * lag;
  wavefront((lines + kBand - 1) / kBand, length, kBand * lag, [&](int index, int first, int last) {
    keeper.run([&] {
      const int v = index * kBand;
      Band<Cell> band;
      band.count = std::min(kBand, lines - v);
      for (int i = 0; i < band.count; ++i) {
        if (first == 0) walk.load_penalties(v + i);
        walk.begin_line(v + i, band.lines[i]);
      }
      advance(walk, band, first, last);
      if (last == length) progress.lines_finished(band.count);
    });
  });
  keeper.rethrow();
}

template void run_pass(PassWalk<std::uint8_t>&, LineProgress&);
template void run_pass(PassWalk<std::uint16_t>&, LineProgress&);

}  // namespace xgm::aggregation
