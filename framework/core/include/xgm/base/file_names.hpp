// SPDX-License-Identifier: Apache-2.0
// Names of files as people and other systems write them: in capitals or not.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "xgm/base/export.hpp"

namespace xgm {

/// The text with its ASCII letters in lower case.
XGM_API std::string lower_case(std::string_view text);

/// `name` if it is among the names, else the only one that differs from it in the case of its
/// letters; "" if there is none, or several.
XGM_API std::string find_name(const std::set<std::string>& names, const std::string& name);

/// The path under which a file is there: each part of `path` that is not there as it is written is
/// looked for as find_name() does. `path` itself if that finds nothing.
XGM_API std::string find_path(const std::string& path);

}  // namespace xgm
