// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "camera.hpp"
#include "compose.hpp"
#include "faults.hpp"
#include "render.hpp"
#include "xgm/base/error.hpp"

namespace xgm::synthesis {
namespace {

constexpr int kMaxObjects = 1000;
constexpr int kLargestDisparity = 1'000'000;

void require(bool holds, const char* message) {
  if (!holds) throw Error(message);
}

void check(const Options& options) {
  require(!options.size.empty() && !options.disparities.empty(),
          "a generated scene needs a size and disparities; give at least 1 x 1 and one");
  require(options.disparities.begin >= -kLargestDisparity &&
              options.disparities.end - 1 <= kLargestDisparity,
          "disparities of generated scenes end at a million px; give fewer");
  require(options.faults.vertical.b > -1,
          "a vertical shift with b <= -1 turns the image over; give b > -1");
  require(options.objects >= 0 && options.objects <= kMaxObjects,
          "a generated scene has 0 to 1000 objects; give such a number");
  require(options.bits == 0 || options.bits == 8 || options.bits == 16,
          "generated images have 8 or 16 bits; give one of them, or 0 for unrounded levels");
  require(options.samples >= 1 && options.samples <= 16,
          "a pixel is sampled by 1 to 16 rays a side; give such a number");
  require(options.lens >= 0 && options.lens <= 50 && options.sensor_noise >= 0 &&
              options.sensor_noise <= 255,
          "lens is 0 to 50 px and sensor_noise 0 to 255 grey levels; give such numbers");
  check(options.faults);
}

/// The farthest surface is five times as far as the nearest one can be.
Calibration make_up_calibration(const Options& options) {
  const double span = std::max(options.disparities.size() - 1, 4);
  Calibration calibration;
  calibration.focal = 0.9 * std::max(options.size.width, options.size.height);
  calibration.cx = (options.size.width - 1) / 2.0;
  calibration.cy = (options.size.height - 1) / 2.0;
  calibration.doffs = 0.25 * span - options.disparities.begin;
  calibration.baseline = 160;
  return calibration;
}

}  // namespace

GeneratedScene generate(const Options& options) {
  check(options);
  const Surfaces surfaces = compose(options);
  GeneratedScene scene;
  scene.disparities = options.disparities;
  scene.calibration = make_up_calibration(options);
  render_truth(surfaces, options, scene);
  for (const bool match : {false, true}) {
    Image& image = match ? scene.pair.match : scene.pair.base;
    image = render_view(surfaces, options, match);
    expose(image, options, match);
  }
  return scene;
}

}  // namespace xgm::synthesis
