// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/scene.hpp"

#include <sstream>

namespace xgm {
namespace {

void note_masked_share(const Image& image, const char* which, std::vector<std::string>& notes) {
  if (image.valid.empty()) return;
  const double share = 1 - cv::countNonZero(image.valid) / static_cast<double>(image.valid.total());
  std::ostringstream text;
  text.precision(3);
  text << which << " image: " << 100 * share << " % of the pixels have no data";
  notes.push_back(text.str());
}

}  // namespace

Scene load_scene(const SceneFiles& files) {
  Scene scene;
  scene.name = files.name;
  scene.disparities = files.disparities;
  scene.calibration = files.calibration;
  ReadPair read = read_pair(files.images);
  scene.pair = std::move(read.pair);
  scene.notes = std::move(read.notes);
  note_masked_share(scene.pair.base, "left", scene.notes);
  note_masked_share(scene.pair.match, "right", scene.notes);
  scene.inputs = identify_files(files_of(files));
  return scene;
}

Interval clip_to_width(Interval interval, int width) {
  return intersect(interval, {1 - width, width});
}

}  // namespace xgm
