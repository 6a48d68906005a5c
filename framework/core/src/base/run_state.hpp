// SPDX-License-Identifier: Apache-2.0
// What belongs to a run rather than to the process. A thread knows the run that it works for; the
// loops of xgm/base/parallel.hpp hand it on to their threads.
#pragma once

#include <cstdint>
#include <memory>
#include <stop_token>

#include "xgm/base/export.hpp"

namespace xgm {

class BufferPool;
class KeptResults;

/// Never changed while a thread works with it: who needs another one makes a RunChange.
struct RunState {
  std::int64_t simd = 0;               ///< bits of the targets that kernels may use; 0: all
  std::shared_ptr<BufferPool> pool{};  ///< of large buffers; null: each stands alone
  std::stop_token stop{};
  KeptResults* kept = nullptr;  ///< may be null
};

/// Of the calling thread. Outside runs: one that says nothing.
XGM_API const RunState& run_state();

/// While this lives, the calling thread has `state`, which must live as long.
class XGM_API RunScope {
 public:
  explicit RunScope(const RunState& state);
  ~RunScope();
  RunScope(const RunScope&) = delete;
  RunScope& operator=(const RunScope&) = delete;

 private:
  const RunState* before_;
};

/// While this lives, the calling thread has a state of its own.
struct RunChange {
  explicit RunChange(RunState changed) : state(std::move(changed)) {}
  const RunState state;
  const RunScope scope{state};
};

}  // namespace xgm
