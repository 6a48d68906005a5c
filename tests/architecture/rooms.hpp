// SPDX-License-Identifier: Apache-2.0
// The rooms of the framework (framework/<room>), the folders of each, and which may include which.
#pragma once

#include <set>
#include <string>

#include "architecture/tree.hpp"

namespace xgm::architecture {

/// Where a source of the framework lies.
struct Place {
  std::string room;        ///< "core", "evaluation" ...
  std::string folder;      ///< first folder below src or below the public headers; may be ""
  bool is_public = false;  ///< a header below include
};

/// Of a path below framework/<room>/src or framework/<room>/include. The public header
/// xgm/plugin.hpp belongs to the folder `plugin`, and so with each that has the name of a folder.
Place place_of(const std::string& file);

/// The room whose public header "xgm/..." this is.
std::string room_of_header(const std::string& target);

/// The rooms that a room may include; nothing if the room has no line in the table.
const std::set<std::string>* rooms_below(const std::string& room);

/// Whether a file in one folder of core may include a file in another:
/// base < data, config < stage < plugin < io < exchange < pipeline.
bool core_folder_may_include(const std::string& from, const std::string& to);
/// Whether the folder has a place in that order.
bool is_core_folder(const std::string& folder);

}  // namespace xgm::architecture
