// SPDX-License-Identifier: Apache-2.0
// Numbers and strings as the tables write them.
#pragma once

#include <string>

namespace xgm {

/// "0.5", "1", "2"
std::string short_number(double value);
/// With so many decimals. A zero has no sign.
std::string fixed_number(double value, int decimals);

}  // namespace xgm
