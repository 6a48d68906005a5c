// SPDX-License-Identifier: Apache-2.0
// No file that is read is lost to one that is written.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

/// A file, and what it is to the user: "truth", "right mask"; for outputs the option that names it,
/// "--cloud".
struct NamedFile {
  std::string role;
  std::string file;  ///< empty: there is none
};

/// To be called before work begins. Throws UsageError if an output is one of the inputs, under
/// whatever path or link, or the same file as another output, or a folder, a device or a pipe.
XGM_API void require_apart(const std::vector<NamedFile>& inputs,
                           const std::vector<NamedFile>& outputs);

}  // namespace xgm
