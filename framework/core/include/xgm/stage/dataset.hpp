// SPDX-License-Identifier: Apache-2.0
// Kind "dataset": finds the scenes in a folder by the layout of its files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "xgm/data/scene_files.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

/// Not a step of a pipeline: it tells programs what there is to match, and by which truth to judge.
class XGM_API Dataset : public Stage {
 public:
  static constexpr std::string_view kKind = "dataset";
  static constexpr std::string_view kMeaning =
      "finds the scenes in a folder, and by which truth to judge them";

  /// The scenes of this data set in `folder`, sorted by name: the folder itself may be a scene, or
  /// hold scenes in the data set's own layout. None if it is laid out otherwise. Opens no image.
  /// Throws Error, naming the file and the remedy, if it is such a folder but cannot be used. What
  /// is wrong with a file of one scene is told in SceneFiles::faults, and stops no other scene.
  virtual std::vector<SceneFiles> scenes(const std::string& folder) const = 0;

  /// What a scene of this layout has, in a few words for messages: "im0 and im1".
  virtual std::string layout() const = 0;
};

}  // namespace xgm
