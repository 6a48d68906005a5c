// SPDX-License-Identifier: Apache-2.0
// Whether a cell's files are those that a bench would make now.
#pragma once

#include <string>

#include "xgm/evaluation/bench.hpp"

namespace xgm {

/// All that decides what a cell's run gives, as JSON.
std::string cell_identity(const BenchRequest& request, std::size_t pipeline, std::size_t scene);

/// Whether mark_done was called for this folder and identity, and the results are as they were
/// then.
bool is_done(const std::string& folder, const std::string& identity);

/// Before a run: what is there tells of nothing any more. Throws Error.
void begin_cell(const std::string& folder);
/// After a run that succeeded. Throws Error.
void mark_done(const std::string& folder, const std::string& identity);

}  // namespace xgm
