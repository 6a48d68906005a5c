// SPDX-License-Identifier: Apache-2.0
// Where the code of this process comes from.
#pragma once

#include <string>

namespace xgm {

/// The file that holds this function: a library, or the program. "" if nobody knows.
std::string loaded_from(const void* function);

}  // namespace xgm
