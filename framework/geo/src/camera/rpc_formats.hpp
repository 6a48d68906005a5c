// SPDX-License-Identifier: Apache-2.0
// The readers behind read_rpc(), a file each.
#pragma once

#include <string>
#include <vector>

#include "xgm/geo/camera/rpc_model.hpp"

namespace xgm::geo {

/// DIMAP, DigitalGlobe, EnMAP.
std::vector<RpcModel> read_xml_rpc(const std::string& file);
/// "KEY: value", .RPB, dictionaries in YAML and JSON.
std::vector<RpcModel> read_text_rpc(const std::string& file);

}  // namespace xgm::geo
