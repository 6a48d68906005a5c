// SPDX-License-Identifier: Apache-2.0
// A resolved configuration as an indented tree.
#pragma once

#include <string>

#include "xgm/base/json.hpp"

namespace xgm {

std::string graph_text(const Json& resolved);

}  // namespace xgm
