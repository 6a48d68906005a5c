// SPDX-License-Identifier: Apache-2.0
#include "architecture/rules.hpp"

namespace xgm::architecture {

Violations missing_licences(const Tree& tree) {
  Violations violations;
  for (const auto& [file, text] : tree) {
    const bool found = text.starts_with("// SPDX-License-Identifier: Apache-2.0\n") ||
                       text.starts_with("/* SPDX-License-Identifier: Apache-2.0 */\n") ||
                       text.starts_with("# SPDX-License-Identifier: Apache-2.0\n");
    if (!found) violations.push_back(file + " does not begin with the SPDX line");
  }
  return violations;
}

}  // namespace xgm::architecture
