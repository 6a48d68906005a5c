// SPDX-License-Identifier: Apache-2.0
// The smallest program: a shipped pipeline on the built-in sample pair.
#include <iostream>
#include <xgm/pipeline.hpp>
#include <xgm/synthesis/plain_scene.hpp>

int main() {
  const xgm::Registry plugins = xgm::Registry::with_builtins();
  const xgm::Pipeline pipeline = xgm::require_pipeline("sgm8", plugins);
  const xgm::SceneRun run = xgm::run_scene(pipeline, {.scene = xgm::synthesis::sample_scene()});
  const xgm::DisparityMap& map = run.maps.forward;
  std::cout << "disparity at (320, 240): " << map.disparity(240, 320) << " px\n";
  xgm::write_maps("sample", map);
}
