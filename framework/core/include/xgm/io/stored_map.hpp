// SPDX-License-Identifier: Apache-2.0
// A disparity map in files that give it back to the last bit, for runs that go on later.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"

namespace xgm {

/// Writes NAME.pfm (px, +inf where there is no disparity), NAME_status.png (8 bit, the numbers of
/// Status) and, of a map with a confidence, NAME_confidence.pfm to the folder, which is there.
/// Returns the files' names in it. Throws Error.
XGM_API std::vector<std::string> write_stored_map(const std::string& folder,
                                                  const std::string& name, const DisparityMap& map);

/// Throws Error if the files are not those of a map.
XGM_API DisparityMap read_stored_map(const std::string& folder, const std::string& name);

}  // namespace xgm
