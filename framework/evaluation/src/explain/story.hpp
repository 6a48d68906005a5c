// SPDX-License-Identifier: Apache-2.0
// What happened to a pixel, in words.
#pragma once

#include <optional>
#include <string>

#include "xgm/evaluation/explain.hpp"

namespace xgm::explain {

/// "12.31"; whole numbers without a point.
std::string number(double value);
/// "-3 to 12", or "nothing".
std::string range_text(Interval range);
/// A disparity, or the reason why there is none.
std::string state_text(const PixelState& state);

Effect effect_of(const std::optional<PixelState>& before, const PixelState& after);
/// "12 -> 12.31 (+0.31)"
std::string change_text(const std::optional<PixelState>& before, const PixelState& after);

/// "filters[0] median": the last part of the path and, if that says more, the plugin.
std::string stage_name(const ExplainedEvent& event);

/// Why the pixel is what it is.
std::string verdict(const Explanation& explanation);
/// Where the truth was lost; empty if it is not known.
std::string diagnosis(const Explanation& explanation);

}  // namespace xgm::explain
