// SPDX-License-Identifier: Apache-2.0
// Where results will go: tried before anything is computed that could not be kept.
#pragma once

#include <string>

namespace xgm::cli {

/// Makes the folder if it is missing. Throws UsageError, which begins with `option` ("--output "),
/// if it cannot be made or written to.
void make_output_folder(const std::string& option, const std::string& folder);

/// Throws UsageError, which begins with `option`, if no file can be written to the folder ("" is
/// the current one).
void require_writable(const std::string& option, const std::string& folder);

}  // namespace xgm::cli
