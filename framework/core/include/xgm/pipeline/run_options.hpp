// SPDX-License-Identifier: Apache-2.0
// What a run is given besides images: its resources, who is told of it, and how it is ended.
#pragma once

#include <stop_token>
#include <string>

namespace xgm {

class Observer;

struct RunOptions {
  Observer* observer = nullptr;  ///< told of every stage; outlives the run; null: nobody
  int threads = 0;               ///< 0: all processors
  std::string simd{};            ///< one of simd_targets(); empty: the best
  /// Ends the run from another thread: it throws Cancelled, usually within a tenth of a second.
  std::stop_token stop{};
};

}  // namespace xgm
