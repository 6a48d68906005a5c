// SPDX-License-Identifier: Apache-2.0
// Names of pipelines and sets of scenes: unique, and fit for folders.
#pragma once

#include <string>
#include <vector>

#include "xgm/evaluation/bench.hpp"

namespace xgm {

/// `text` with letters, digits and ._-+=, only, of a length that file systems take.
std::string folder_name(const std::string& text);

/// Gives every scene the name of its set: that of the data folder, or of the folder around it if
/// the data folder is the scene.
void name_sets(std::vector<BenchScene>& scenes);

}  // namespace xgm
