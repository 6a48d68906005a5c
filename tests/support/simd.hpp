// SPDX-License-Identifier: Apache-2.0
// Tests that run with every SIMD target of the processor.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "xgm/base/simd.hpp"

namespace xgm::testing {

/// Calls body() with each target in use.
template <class Body>
void with_each_simd_target(const Body& body) {
  for (const std::string& target : simd_targets()) {
    CAPTURE(target);
    const SimdChoice choice(target);
    body();
  }
}

}  // namespace xgm::testing
