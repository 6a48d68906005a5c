// SPDX-License-Identifier: Apache-2.0
// What the YAML parser says of a file, in words that help its writer.
#pragma once

#include <string>

#include "config/node.hpp"

namespace xgm {

/// The diagnostic of a parser's message about `text` at `where`.
Diagnostic explain_syntax(const std::string& text, const Location& where,
                          const std::string& message);

}  // namespace xgm
