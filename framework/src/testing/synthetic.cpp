// SPDX-License-Identifier: Apache-2.0
#include "xgm/testing/synthetic.hpp"

namespace xgm::testing {

SyntheticScene make_scene(const SceneOptions& options) {
  synthesis::Options plain;
  plain.size = options.size;
  plain.disparities = options.disparities;
  plain.seed = options.seed;
  plain.objects = options.objects;
  plain.colour = options.colour;
  plain.bits = options.whole_levels ? 8 : 0;
  plain.content = synthesis::Content::plain;
  plain.lens = 0;
  plain.samples = 1;
  plain.sensor_noise = 0;
  plain.faults.exposure = options.gain;
  plain.faults.bias = options.bias;
  plain.faults.noise = options.noise;
  plain.faults.vertical = options.shift;
  return synthesis::generate(plain);
}

SyntheticScene sample_scene() {
  SceneOptions options;
  options.size = {640, 480};
  options.disparities = {0, 64};
  options.seed = 3;
  options.objects = 9;
  options.colour = true;
  options.noise = 1;
  return make_scene(options);
}

}  // namespace xgm::testing
