// SPDX-License-Identifier: Apache-2.0
// Highway's dispatch, made to choose one target after the other.
#pragma once

#include <hwy/highway.h>

#include "xgm/base/simd.hpp"

namespace xgm::bench {

/// Calls body() with every SIMD target of this processor, best first.
template <class Body>
void for_each_target(Body body) {
  for (const std::string& target : simd_targets()) {
    const SimdChoice choice(target);
    body();
  }
}

}  // namespace xgm::bench
