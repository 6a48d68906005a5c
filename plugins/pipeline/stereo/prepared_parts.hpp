// SPDX-License-Identifier: Apache-2.0
// A pair as one preprocess stage leaves it, read in parts.
#pragma once

#include <memory>

#include "xgm/data/pair_windows.hpp"
#include "xgm/stage/preprocess.hpp"

namespace xgm::stereo {

/// `stage` outlives the result.
std::shared_ptr<const PairWindows> prepared(std::shared_ptr<const PairWindows> scene,
                                            const Preprocess& stage, const Context& context);

}  // namespace xgm::stereo
