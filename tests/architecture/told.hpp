// SPDX-License-Identifier: Apache-2.0
// For the failure messages of tests.
#pragma once

#include <string>

#include "architecture/tree.hpp"

namespace xgm::architecture {

inline std::string told(const Violations& violations) {
  std::string text;
  for (const std::string& violation : violations) text += violation + "\n";
  return text;
}

}  // namespace xgm::architecture
