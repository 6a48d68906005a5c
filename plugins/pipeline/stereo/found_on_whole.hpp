// SPDX-License-Identifier: Apache-2.0
// What preprocess stages have found on a whole scene, as JSON that another process goes on from: a
// list with one element for each stage,
//   {"stage": "ransac_deskew", "fitted": true, "state": {"a": ..., "b": ..., "c": ...}}
#pragma once

#include <memory>
#include <string>

#include "xgm/base/json.hpp"
#include "xgm/stage/preprocess.hpp"

namespace xgm::stereo {

/// `fitted`: what Preprocess::fitted() returned. Warns if it cannot be handed on.
Json record_of(const std::string& plugin, const PartPreprocess* fitted, const Context& context);

/// What the record is of; fitted to the scene anew if it could not be handed on. Throws Error if it
/// is not of this stage.
std::shared_ptr<const PartPreprocess> fitted_by(const Json& record, const std::string& plugin,
                                                const Preprocess& stage, const PairWindows& scene,
                                                const Context& context);

}  // namespace xgm::stereo
