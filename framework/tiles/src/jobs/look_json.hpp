// SPDX-License-Identifier: Apache-2.0
// What was found in the images, as JSON of a manifest.
#pragma once

#include "xgm/base/json.hpp"
#include "xgm/io/pair_in_files.hpp"

namespace xgm::tiles {

/// Numbers are read as they were, to the last bit.
Json to_json(const PairLook& look);
/// Throws Error.
PairLook look_of(const Json& json);

}  // namespace xgm::tiles
