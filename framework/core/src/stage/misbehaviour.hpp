// SPDX-License-Identifier: Apache-2.0
// Whatever a plugin does wrong becomes an Error that names it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "xgm/data/fault.hpp"
#include "xgm/stage/place.hpp"

namespace xgm {

/// The place of a stage that no slot calls.
StagePlace place_of(std::string_view kind, const std::string& plugin);

/// "filter 'median'"
std::string name_of(const StagePlace& stage);

/// Throws Error if there is a fault in what this stage has returned.
void require_none(const std::optional<Fault>& fault, const StagePlace& stage);

/// Rethrows the exception that is being handled: Cancelled and Errors that know their stage as they
/// are, all else as an Error of this stage.
[[noreturn]] void rethrow_as_error(const StagePlace& stage);

}  // namespace xgm
