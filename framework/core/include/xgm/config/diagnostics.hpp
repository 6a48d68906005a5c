// SPDX-License-Identifier: Apache-2.0
// Diagnostics: mistakes in a configuration, each with its place and a remedy.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

/// A place in a file. Line and column are counted from 1; 0 if unknown. `file` may also name the
/// command line.
struct Location {
  std::string file;
  int line = 0;
  int column = 0;
};

struct Diagnostic {
  Location where;
  std::string message;  ///< what is wrong
  std::string remedy;   ///< what to do about it
};

using Diagnostics = std::vector<Diagnostic>;

/// "file:line:column: error: message; remedy"
XGM_API std::string to_string(const Diagnostic& diagnostic);
/// All of them, a line each; no line end after the last.
XGM_API std::string to_string(const Diagnostics& diagnostics);

}  // namespace xgm
