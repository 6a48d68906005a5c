// SPDX-License-Identifier: Apache-2.0
// Generated stereo pairs for tests, under short names.
#pragma once

#include "xgm/synthesis/plain_scene.hpp"

namespace xgm::testing {

using synthesis::VerticalShift;
using SceneOptions = synthesis::PlainOptions;
using SyntheticScene = synthesis::GeneratedScene;

inline SyntheticScene make_scene(const SceneOptions& options) {
  return synthesis::generate_plain(options);
}

}  // namespace xgm::testing
