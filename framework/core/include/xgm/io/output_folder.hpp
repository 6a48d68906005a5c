// SPDX-License-Identifier: Apache-2.0
// Where results will go: tried before anything is computed that could not be kept.
#pragma once

#include <string>

#include "xgm/base/export.hpp"

namespace xgm {

/// Makes the folder if it is missing. Throws UsageError if it cannot be made or written to; the
/// message begins with `what` ("--output ").
XGM_API void make_output_folder(const std::string& folder, const std::string& what = {});

/// Throws UsageError if no file can be written to the folder ("" is the current one); the message
/// begins with `what`.
XGM_API void require_writable(const std::string& folder, const std::string& what = {});

}  // namespace xgm
