// SPDX-License-Identifier: Apache-2.0
// A pair as one preprocess stage leaves it, read in parts.
#pragma once

#include <memory>

#include "xgm/data/pair_windows.hpp"
#include "xgm/stage/preprocess.hpp"

namespace xgm::stereo {

/// `fitted`: what the stage has found on the scene; may be null. `stage` outlives the result.
std::shared_ptr<const PairWindows> prepared(std::shared_ptr<const PairWindows> scene,
                                            const Preprocess& stage,
                                            std::shared_ptr<const PartPreprocess> fitted);

}  // namespace xgm::stereo
