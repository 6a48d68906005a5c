// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/path_engine/run_opposed_passes.hpp"

#include <algorithm>

#include "plugins/aggregation/path_engine/advance.hpp"
#include "xgm/base/parallel.hpp"

namespace xgm::aggregation {

template <class Cell>
void run_opposed_passes(PassWalk<Cell>& forward, PassWalk<Cell>& backward, bool begin_sums,
                        LineProgress& progress) {
  PassWalk<Cell>* const walks[] = {&forward, &backward};
  const Advance<Cell> advance[] = {choose_advance<Cell>(forward.step()),
                                   choose_advance<Cell>(backward.step())};
  ExceptionKeeper keeper;
  forward.load_penalties();
  backward.load_penalties();
  // The last line of a band reaches its end (kBand - 1) * lag pixels after the first. The wavefront
  // treats a band as one line that is longer by that much.
  const int lag = forward.lag(), length = forward.frame().length() + (kBand - 1) * lag;
  opposed_wavefronts(bands_of(forward.frame().lines()), length, kBand * lag,
                     [&](const Stretch& at) {
                       keeper.run([&] {
                         PassWalk<Cell>& walk = *walks[at.front];
                         const int end = walk.frame().first_line() + walk.frame().lines();
                         const int v = std::max(at.line * kBand, walk.frame().first_line());
                         Band<Cell> band;
                         band.count = std::min((at.line + 1) * kBand, end) - v;
                         for (int i = 0; i < band.count; ++i) {
                           if (at.first == 0) walk.load_penalties(v + i);
                           walk.begin_line(v + i, begin_sums && at.new_line, band.lines[i]);
                         }
                         advance[at.front](walk, band, at.first, at.last);
                         if (at.last == length) progress.lines_finished(band.count);
                       });
                     });
  keeper.rethrow();
}

template void run_opposed_passes(PassWalk<std::uint8_t>&, PassWalk<std::uint8_t>&, bool,
                                 LineProgress&);
template void run_opposed_passes(PassWalk<std::uint16_t>&, PassWalk<std::uint16_t>&, bool,
                                 LineProgress&);

}  // namespace xgm::aggregation
