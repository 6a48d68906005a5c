// SPDX-License-Identifier: Apache-2.0
// Files that options like --json name, which may be standard output instead.
#pragma once

#include <string>
#include <vector>

#include "xgm/io/require_apart.hpp"

namespace xgm::cli {

inline constexpr const char* kStandardOutput = "-";

/// Before any work. Throws UsageError if an output is an input, or cannot be a file.
void require_outputs_apart(const std::vector<NamedFile>& inputs, std::vector<NamedFile> outputs);

/// Before long work. Throws UsageError if the output's folder cannot be written to.
void require_writable_output(const NamedFile& output);

/// To the file or standard output; nowhere if it is empty. Throws Error.
void write_output(const std::string& file, const std::string& text);

}  // namespace xgm::cli
