// SPDX-License-Identifier: Apache-2.0
// Values of declared parameters: from configuration nodes, to JSON, and in words.
#pragma once

#include <string>

#include "config/node.hpp"
#include "xgm/base/json.hpp"
#include "xgm/config/parameters.hpp"

namespace xgm {

/// Whether the field holds a stage or a list of stages rather than a value.
bool is_stage(const Field& field);
bool is_stage_list(const Field& field);
/// Kind of the stages of a stage field.
std::string_view stage_kind(const Field& field);

/// "an odd whole number from 3 to 9", "one of sgbm, hh", "true or false"
std::string expected(const Field& field);

/// Puts the node's value into the field (not for stage fields). False with a diagnostic if it is of
/// the wrong type or out of range.
bool bind_value(const Field& field, const Node& node, Diagnostics& diagnostics);

/// The value that a (non-stage) field holds now.
Json value_of(const Field& field);

}  // namespace xgm
