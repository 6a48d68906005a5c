// SPDX-License-Identifier: Apache-2.0
// Tests that run with every SIMD target of the processor.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "xgm/base/simd.hpp"

namespace xgm::testing {

/// Calls body() with each target in use, and the best one again afterwards.
template <class Body>
void with_each_simd_target(const Body& body) {
  struct Restore {
    ~Restore() { use_simd(""); }
  } const restore;
  for (const std::string& target : simd_targets()) {
    CAPTURE(target);
    use_simd(target);
    body();
  }
}

}  // namespace xgm::testing
