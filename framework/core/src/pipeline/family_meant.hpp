// SPDX-License-Identifier: Apache-2.0
// Which family of pipelines a file without a type is meant for.
#pragma once

#include <string_view>

#include "config/node.hpp"
#include "xgm/plugin/registry.hpp"

namespace xgm {

/// Puts "type: FAMILY" at the top of a pipeline file.
void put_type(Node& root, std::string_view family);

/// Where a file names no type, and another family than the default one knows more of its keys, puts
/// the type of that there, with a diagnostic: what else is wrong is then said of the right family.
void put_type_meant(Node& root, const Registry& registry, Diagnostics& diagnostics);

}  // namespace xgm
