// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/scene.hpp"
#include "xgm/testing/synthetic.hpp"

namespace xgm {

Scene sample_scene() {
  testing::SyntheticScene generated = testing::sample_scene();
  Scene scene;
  scene.name = "built-in sample pair";
  scene.pair = std::move(generated.pair);
  scene.disparities = generated.disparities;
  scene.truth = {generated.truth, generated.reverse_truth, generated.non_occluded, {}};
  return scene;
}

}  // namespace xgm
