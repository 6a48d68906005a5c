// SPDX-License-Identifier: Apache-2.0
// What to do about a plugin that there is not.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace xgm {

/// The name that is probably meant, else "<label>: a, b, c" and how plugin files are loaded: the
/// plugin may be in one that nobody has named.
std::string unknown_plugin_remedy(std::string_view written, const std::vector<std::string>& known,
                                  const std::string& label);

}  // namespace xgm
