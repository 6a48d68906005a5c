// SPDX-License-Identifier: Apache-2.0
// The clocks that contestants are timed by.
#pragma once

#include <chrono>
#include <ctime>

#include "xgm/evaluation/speed.hpp"

namespace xgm::speed {

/// Runs from its making on.
class Clocks {
 public:
  RunSeconds seconds() const {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_;
    return {wall.count(), static_cast<double>(std::clock() - cpu_) / CLOCKS_PER_SEC};
  }

 private:
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
  std::clock_t cpu_ = std::clock();  // of the whole process
};

}  // namespace xgm::speed
