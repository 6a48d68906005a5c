// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "xgm/base/export.hpp"
#include "xgm/geo/camera/rpc_model.hpp"

namespace xgm::geo {

/// The model as "KEY: value" lines (_RPC.TXT), which GDAL and read_rpc() read; every digit is kept.
XGM_API std::string rpc_text(const RpcModel& model);

}  // namespace xgm::geo
