// SPDX-License-Identifier: Apache-2.0
// Whether text is encoded as YAML has to be.
#pragma once

#include <string_view>

namespace xgm {

/// Whether each character is one byte below 128, or a first byte and as many others as that tells.
bool is_utf8(std::string_view text);

}  // namespace xgm
