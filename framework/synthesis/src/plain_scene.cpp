// SPDX-License-Identifier: Apache-2.0
#include "xgm/synthesis/plain_scene.hpp"

namespace xgm::synthesis {

GeneratedScene generate_plain(const PlainOptions& options) {
  Options plain;
  plain.size = options.size;
  plain.disparities = options.disparities;
  plain.seed = options.seed;
  plain.objects = options.objects;
  plain.colour = options.colour;
  plain.bits = options.whole_levels ? 8 : 0;
  plain.content = Content::plain;
  plain.lens = 0;
  plain.samples = 1;
  plain.sensor_noise = 0;
  plain.faults.exposure = options.gain;
  plain.faults.bias = options.bias;
  plain.faults.noise = options.noise;
  plain.faults.vertical = options.shift;
  return generate(plain);
}

GeneratedScene sample_pair() {
  PlainOptions options;
  options.size = {640, 480};
  options.disparities = {0, 64};
  options.seed = 3;
  options.objects = 9;
  options.colour = true;
  options.noise = 1;
  return generate_plain(options);
}

Scene sample_scene() {
  GeneratedScene generated = sample_pair();
  Scene scene;
  scene.name = "built-in sample pair";
  scene.pair = std::move(generated.pair);
  scene.disparities = generated.disparities;
  scene.truth = {generated.truth, generated.reverse_truth, generated.non_occluded, {}};
  return scene;
}

}  // namespace xgm::synthesis
