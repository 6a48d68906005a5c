// SPDX-License-Identifier: Apache-2.0
// Files that come with the library: pipelines, and what their stages read.
#pragma once

#include <string>

#include "xgm/base/export.hpp"

namespace xgm {

/// The folder of the shipped pipelines: share/xgm/pipelines below the prefix that holds the
/// library's folder. "" if there is none.
XGM_API std::string shipped_folder();

/// The file that a stage means by `path`: the one there, else the shipped one of this path. `path`
/// itself if there is neither.
XGM_API std::string find_shipped(const std::string& path);

}  // namespace xgm
