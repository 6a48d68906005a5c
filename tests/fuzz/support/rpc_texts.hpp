// SPDX-License-Identifier: Apache-2.0
// One RPC camera in the formats of vendors, for fuzzers to begin with.
#pragma once

#include <string>
#include <vector>

#include "xgm/geo/camera/rpc_model.hpp"

namespace xgm::fuzz {

/// Requires what holds of every camera that was read: there is one, its numbers are finite, its
/// scales are not 0, and written as text and read again it is the same.
void check_cameras(const std::vector<geo::RpcModel>& models);

/// "KEY: value", a line each.
std::string sample_text();
/// Names of fields as formats spell them, and numbers that are hard to read.
std::vector<std::string> rpc_words();

}  // namespace xgm::fuzz
