// SPDX-License-Identifier: Apache-2.0
// "Did you mean ...?" for misspelt names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

/// The name that is so close that it is probably meant; "" if there is none.
XGM_API std::string closest(std::string_view written, const std::vector<std::string>& names);

/// "did you mean 'census'?" if a name is close enough, else "<label>: a, b, c".
XGM_API std::string suggest(std::string_view written, const std::vector<std::string>& names,
                            const std::string& label);

/// "a, b, c"
XGM_API std::string join(const std::vector<std::string>& names);

}  // namespace xgm
