// SPDX-License-Identifier: Apache-2.0
// A resolved configuration as an indented tree.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "xgm/config/parameters.hpp"

namespace xgm {

std::string graph_text(const nlohmann::ordered_json& resolved);

/// The declaration of a pipeline file's top level, with defaults.
ParameterSet pipeline_parameters();

}  // namespace xgm
