// SPDX-License-Identifier: Apache-2.0
#include "base/run_state.hpp"

namespace xgm {
namespace {

constinit const RunState kNoRun;
thread_local const RunState* current = &kNoRun;

}  // namespace

const RunState& run_state() { return *current; }

RunScope::RunScope(const RunState& state) : before_(current) { current = &state; }
RunScope::~RunScope() { current = before_; }

}  // namespace xgm
