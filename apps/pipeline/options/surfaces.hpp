// SPDX-License-Identifier: Apache-2.0
// Pipelines that make surfaces of satellite images.
#pragma once

#include <initializer_list>
#include <string>

#include "xgm/pipeline/pipeline.hpp"

namespace xgm::cli {

/// Always false in a program without the room geo.
bool makes_surfaces(const Pipeline& pipeline);

/// An option that has no meaning for pipelines that make surfaces.
struct PairOption {
  const char* name;
  bool is_given;
  const char* remedy;  ///< what there is in its place
};
/// Throws UsageError for the first that is given.
void refuse_for_surfaces(std::initializer_list<PairOption> options);

/// For commands that match one pair: throws UsageError if the pipeline makes surfaces. `command` is
/// its name, `remedy` what there is in its place.
void require_pair_pipeline(const Pipeline& pipeline, const std::string& command,
                           const std::string& remedy);

}  // namespace xgm::cli
