// SPDX-License-Identifier: Apache-2.0
// A calibration as other programs and later runs read it.
#pragma once

#include "xgm/base/export.hpp"
#include "xgm/base/json.hpp"
#include "xgm/data/calibration.hpp"

namespace xgm {

/// {focal, cx, cy, doffs, baseline}, to the last bit.
XGM_API Json to_json(const Calibration& cameras);
/// Throws Error if a number is missing.
XGM_API Calibration calibration_of(const Json& json);

}  // namespace xgm
