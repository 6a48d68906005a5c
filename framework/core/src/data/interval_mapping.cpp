// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/interval_mapping.hpp"

#include <cmath>

namespace xgm {

Interval divided(Interval interval, double scale) {
  if (interval.empty()) return {};
  return {static_cast<int>(std::floor(interval.begin / scale)),
          static_cast<int>(std::ceil((interval.end - 1) / scale)) + 1};
}

Interval reversed(Interval interval) {
  return interval.empty() ? Interval{} : Interval{1 - interval.end, 1 - interval.begin};
}

}  // namespace xgm
