// SPDX-License-Identifier: Apache-2.0
// A resolved configuration as an indented tree.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace xgm {

std::string graph_text(const nlohmann::ordered_json& resolved);

}  // namespace xgm
