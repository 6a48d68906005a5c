// SPDX-License-Identifier: Apache-2.0
// What the stages of a run may know of it beside what they are given.
#pragma once

#include <optional>
#include <string>

#include "xgm/data/calibration.hpp"

namespace xgm {

/// Hardly any stage needs it: those that read files of a scene, or hand the scene to other
/// programs.
struct RunFacts {
  std::string scene{};                       ///< its name; empty if it has none
  std::optional<Calibration> calibration{};  ///< of the run's images, if it is known
  /// Whether only the memory and the time of the run are of interest, and its images are smaller
  /// than those of the scene. Stages that start programs, or read maps of the scene's size, answer
  /// with anything then that keeps the rules of their kind.
  bool rehearsal = false;
};

}  // namespace xgm
