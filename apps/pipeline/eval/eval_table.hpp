// SPDX-License-Identifier: Apache-2.0
// The figures of an evaluation for people: tables at most 80 columns wide.
#pragma once

#include <string>

#include "xgm/evaluation/evaluation_report.hpp"

namespace xgm::cli {

/// Rows are regions; shares are in percent, errors in px.
std::string table(const EvaluationReport& report);

}  // namespace xgm::cli
