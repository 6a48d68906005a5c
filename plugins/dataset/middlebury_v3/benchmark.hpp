// SPDX-License-Identifier: Apache-2.0
// What Middlebury's evaluation, version 3, fixes per scene: weights and resolutions.
#pragma once

#include <string>

namespace xgm::middlebury_v3 {

/// Weight of a training scene in the averages of the benchmark's table: 1 or 0.5.
double weight(const std::string& scene);

/// How many pixels of full resolution one of this folder is wide: 4, 2 or 1 by the folder's name
/// ("trainingQ", "testH", "trainingF"); 0 if it does not say.
double scale_of_folder(const std::string& name);

/// The same by the width of the images (0: not known), for the training scenes; 1 for others.
double scale_of_width(const std::string& scene, int width);

}  // namespace xgm::middlebury_v3
