// SPDX-License-Identifier: Apache-2.0
// Numbers in spellings of other languages, for remedies.
#pragma once

#include <optional>
#include <string>

namespace xgm {

/// The number that is meant by "1_000", "0x10", "0o10", "0b10", "1,5", "1e3" or "5.0".
std::optional<double> meant_number(const std::string& text);

}  // namespace xgm
