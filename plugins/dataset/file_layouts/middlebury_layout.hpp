// SPDX-License-Identifier: Apache-2.0
// The layout that Middlebury's evaluation version 3 and ETH3D share: one folder per scene with
// im0, im1 and calib.txt. What tells them apart is the names of the scenes.
#pragma once

#include <string>
#include <vector>

#include "plugins/dataset/file_layouts/folders.hpp"
#include "xgm/data/scene_files.hpp"

namespace xgm::dataset {

/// The folders with im0 or im1 that are not of 2001: `folder` itself, or those directly in it.
SceneFolders pair_folders(const std::string& folder);

/// The pair; an image that is not there by the name it should have.
void add_images(SceneFiles& scene, const Listing& folder);

/// Middlebury's scenes of 2001 and 2003, which hold im0 and im1, too, but are not to be matched by
/// them: the pair is im2 and im6, or else there is 8-bit truth (map), or it is tsukuba.
bool is_middlebury_2001(const Listing& folder);
bool is_tsukuba(const Listing& folder);
bool is_map(const Listing& folder);

/// Whether this is a name as ETH3D's two-view scenes have it: "delivery_area_1l", "playground_3s".
bool is_eth3d_name(const std::string& name);
/// Whether there are scenes, and all of them have such names.
bool are_eth3d(const std::vector<Listing>& scenes);

/// Truth of both views and the mask, by the names of the evaluation ("disp0GT.pfm") or of the 2014
/// set ("disp0.pfm"). What is not there goes to scene.missing.
void add_truth(SceneFiles& scene, const Listing& folder);

}  // namespace xgm::dataset
