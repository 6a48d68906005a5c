// SPDX-License-Identifier: Apache-2.0
// Functions whose last bit is the same on every machine: made of +, -, *, / and exact scaling only,
// which libm's exp and pow are not.
#pragma once

#include <cstdint>

#include "xgm/base/export.hpp"

namespace xgm::synthesis {

/// e^x, |x| up to 700, to about 1e-15.
XGM_API double exponential(double x);
/// t^exponent for t >= 0 and exponent > 0.
XGM_API double power(double t, double exponent);

/// 0 to 1 for t from 0 to 1, without slope at both ends; clamped.
XGM_API double smooth_step(double t);

/// Random values (0 to 1) at whole coordinates, smoothly interpolated.
XGM_API double value_noise(std::uint64_t key, double x, double y);

}  // namespace xgm::synthesis
