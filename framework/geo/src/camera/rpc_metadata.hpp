// SPDX-License-Identifier: Apache-2.0
// A camera as GDAL keeps it with an image.
#pragma once

#include <map>
#include <string>

#include "xgm/geo/camera/rpc_model.hpp"

namespace xgm::geo {

/// Names and values of GDAL's metadata domain "RPC", with all digits.
std::map<std::string, std::string> rpc_metadata(const RpcModel& model);

}  // namespace xgm::geo
