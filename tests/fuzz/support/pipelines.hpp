// SPDX-License-Identifier: Apache-2.0
// What holds of every pipeline that was loaded, and what pipeline files are made of.
#pragma once

#include <string>
#include <vector>

#include "xgm/pipeline/pipeline.hpp"

namespace xgm::fuzz {

/// Requires that there is either a pipeline or diagnostics, each a line that begins with one of
/// `places`; and that the pipeline's resolved text is a pipeline, equal to it.
void check_loaded(const LoadedPipeline& loaded, const std::vector<std::string>& places);

/// The text of a shipped pipeline.
std::string shipped_text(const std::string& name);

/// Names of plugins, parameters and choices, and signs of YAML.
std::vector<std::string> yaml_words();

}  // namespace xgm::fuzz
