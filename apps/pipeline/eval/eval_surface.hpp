// SPDX-License-Identifier: Apache-2.0
// pipeline eval --surface: heights against heights.
#pragma once

#include "eval/eval_options.hpp"

namespace xgm::cli {

/// Prints the comparison. Throws UsageError for files that cannot be compared.
int eval_surface(const EvalOptions& options);

}  // namespace xgm::cli
