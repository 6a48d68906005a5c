// SPDX-License-Identifier: Apache-2.0
// The names of points in the space of parameters.
#pragma once

#include <string>
#include <vector>

#include "xgm/pipeline/pipeline.hpp"

namespace xgm {

/// "+scale=4+directions=8": the last part of each path if that tells it from the others, else all
/// of it.
std::string point_name(const std::vector<Override>& values);

}  // namespace xgm
