// SPDX-License-Identifier: Apache-2.0
// The page around what is shown.
#pragma once

#include <string>

namespace xgm::report {

/// A page that fetches nothing. `main`: its content; `scripts`: what stands behind it. Both are
/// HTML.
std::string document(const std::string& title, const std::string& main,
                     const std::string& scripts = {});

}  // namespace xgm::report
