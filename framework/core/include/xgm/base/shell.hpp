// SPDX-License-Identifier: Apache-2.0
// Commands that people copy into a shell.
// Exported for the tests only: the header is not installed.
#pragma once

#include <string>

#include "xgm/base/export.hpp"

namespace xgm {

/// The word as a shell takes it: in quotes if it needs them.
XGM_API std::string shell_word(const std::string& word);

}  // namespace xgm
