// SPDX-License-Identifier: Apache-2.0
// The groups of rooflines.
#pragma once

namespace xgm::bench {

void register_paths();    ///< path/...: updates per second
void register_hamming();  ///< census/..., hamming/...: pixels and cells per second
void register_memory();   ///< memory/...: bytes per second

}  // namespace xgm::bench
