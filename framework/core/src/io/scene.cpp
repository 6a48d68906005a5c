// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/scene.hpp"

#include <sstream>

#include "io/unscaled_image.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/pair_in_files.hpp"

namespace xgm {
namespace {

std::optional<double> masked_share(const Image& image) {
  if (image.valid.empty()) return std::nullopt;
  return 1 - cv::countNonZero(image.valid) / static_cast<double>(image.valid.total());
}

void note_masked_share(std::optional<double> share, const char* which,
                       std::vector<std::string>& notes) {
  if (!share) return;
  std::ostringstream text;
  text.precision(3);
  text << which << " image: " << 100 * *share << " % of the pixels have no data";
  notes.push_back(text.str());
}

/// All but the images.
Scene described(const SceneFiles& files) {
  Scene scene;
  scene.name = files.name;
  scene.disparities = files.disparities;
  scene.calibration = files.calibration;
  std::vector<NamedFile> used = files_of(files);
  std::erase_if(used, [&](const NamedFile& file) { return !fault_of(files, file.file).empty(); });
  scene.inputs = identify_files(used);
  return scene;
}

/// What tells that the calibration is of other images; "" if nothing does.
std::string size_mismatch(const SceneFiles& scene, cv::Size size) {
  const cv::Size& known = scene.calibrated_size;
  const auto fits = [](int calibrated, int side) { return calibrated == 0 || calibrated == side; };
  if (fits(known.width, size.width) && fits(known.height, size.height)) return {};
  const auto side = [](int length) { return length > 0 ? std::to_string(length) : "?"; };
  return scene.calibration_file + ": is about images of " + side(known.width) + " x " +
         side(known.height) + " pixels but these are " + size_text(size);
}

}  // namespace

std::string fault_of(const SceneFiles& scene, const std::string& file) {
  for (const FileFault& fault : scene.faults) {
    if (fault.file == file) return fault.message;
  }
  return {};
}

void require_calibrated_size(const SceneFiles& scene, cv::Size size) {
  const std::string mismatch = size_mismatch(scene, size);
  if (!mismatch.empty()) throw Error(mismatch + "; give the calibration of this size");
}

void require_disparities_of_size(const SceneFiles& scene, cv::Size size) {
  const std::string mismatch = scene.disparities_file.empty() ? "" : size_mismatch(scene, size);
  if (mismatch.empty()) return;
  throw Error(mismatch +
              ", so that ndisp is not theirs; give the calibration of this size, or the range with "
              "--disparities MIN:MAX");
}

Scene load_scene(const SceneFiles& files) {
  ReadPair read = read_pair(files.images);
  Scene scene = described(files);
  scene.pair = std::move(read.pair);
  scene.notes = std::move(read.notes);
  scene.warnings = std::move(read.warnings);
  note_masked_share(masked_share(scene.pair.base), "left", scene.notes);
  note_masked_share(masked_share(scene.pair.match), "right", scene.notes);
  return scene;
}

Scene open_scene(const SceneFiles& files, const std::string& scratch) {
  auto pair = std::make_shared<const PairInFiles>(files.images, scratch);
  Scene scene = described(files);
  scene.notes = pair->notes();
  scene.warnings = pair->warnings();
  note_masked_share(pair->masked_share(false), "left", scene.notes);
  note_masked_share(pair->masked_share(true), "right", scene.notes);
  scene.windows_bytes = pair->held_bytes();
  scene.windows = std::move(pair);
  return scene;
}

Interval clip_to_width(Interval interval, int width) {
  return intersect(interval, {1 - width, width});
}

}  // namespace xgm
