// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them, the same in every locale.
// Exported for the tests only: the header is not installed.
#pragma once

#include <string>

#include "xgm/base/export.hpp"

namespace xgm {

/// The shortest text that gives the same number back: "0.5", "1", "2".
XGM_API std::string short_number(double value);
/// With so many decimals. A zero has no sign.
XGM_API std::string fixed_number(double value, int decimals);

/// "2.50 GB", "800 MB"
XGM_API std::string bytes_text(double bytes);

}  // namespace xgm
