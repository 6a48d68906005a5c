// SPDX-License-Identifier: Apache-2.0
// From the files of a scene's truth to its maps.
#include "io/raster.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {
namespace {

void require_size(cv::Size size, cv::Size wanted, const std::string& file) {
  if (size == wanted) return;
  throw Error(file + ": is " + size_text(size) + " pixels but " + size_text(wanted) +
              " are wanted; give the truth of the same view and resolution");
}

cv::Mat1f read(const DisparityFile& source, cv::Size size) {
  if (source.file.empty()) return {};
  cv::Mat1f map = read_disparities(source.file, source.divisor);
  require_size(map.size(), size, source.file);
  return map;
}

cv::Mat1b read(const std::string& file, cv::Size size) {
  if (file.empty()) return {};
  cv::Mat1b mask = read_mask(file);
  require_size(mask.size(), size, file);
  return mask;
}

}  // namespace

GroundTruth load_truth(const TruthFiles& files, cv::Size size) {
  GroundTruth truth{.disparity = read(files.disparity, size),
                    .reverse = {},
                    .non_occluded = read(files.non_occluded, size),
                    .objects = read(files.objects, size)};
  // The right view may have another width than the left.
  if (!files.reverse.file.empty()) {
    truth.reverse = read_disparities(files.reverse.file, files.reverse.divisor);
  }
  const cv::Mat1f visible = read(files.visible, size);
  if (truth.non_occluded.empty() && !visible.empty()) {
    truth.non_occluded = visible == visible;  // false for NaN
  }
  return truth;
}

}  // namespace xgm
