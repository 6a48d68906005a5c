// SPDX-License-Identifier: Apache-2.0
// What may be replaced by a file.
#pragma once

#include <string>

namespace xgm {

/// Why nothing can be written under this name, with a remedy; empty if it is free or a file's. What
/// is neither file nor folder, such as /dev/null, would be a file afterwards.
std::string objection_to_replacing(const std::string& file);

}  // namespace xgm
