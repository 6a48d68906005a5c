// SPDX-License-Identifier: Apache-2.0
// The include directives of a file, and the files of the tree that they mean.
#pragma once

#include <string>
#include <vector>

#include "architecture/tree.hpp"

namespace xgm::architecture {

struct Include {
  std::string target;   ///< as written, without its quotes or brackets
  bool quoted = false;  ///< "..." and not <...>
};

std::vector<Include> includes_of(const std::string& text);

/// The file of the tree that is meant, or "" for headers of others.
std::string resolve(const std::string& file, const std::string& target, const Tree& tree);

/// "framework/core/include/xgm/base/error.hpp" of "xgm/base/error.hpp"; "" unless it is "xgm/...".
std::string public_header(const std::string& target);

/// Whether this is the beginning of the header's path: of yaml-cpp, spdlog, CLI11, nlohmann/json,
/// GDAL or PROJ. They stay inside the rooms and applications that use them.
bool is_inner_library(const std::string& target);

}  // namespace xgm::architecture
