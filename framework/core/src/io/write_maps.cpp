// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/write_maps.hpp"

#include <filesystem>

#include "io/encode_png.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm {

void write_maps(const std::string& folder, const DisparityMap& map) {
  make_output_folder(folder);
  const auto in = [&](const char* name) { return (std::filesystem::path(folder) / name).string(); };
  const auto [map_file, picture, statuses] = kMapFiles;
  std::string shown, status_shown;
  parallel_for(0, 3, [&, map_file = map_file, picture = picture, statuses = statuses](int i) {
    if (i == 0) write_pfm(in(map_file), map.disparity);
    if (i == 1) shown = encode_png(in(picture), disparity_picture(map));
    if (i == 2) status_shown = encode_png(in(statuses), status_picture(map));
  });
  write_file(in(picture), shown);
  write_file(in(statuses), status_shown);
  if (map.confidence.empty()) {
    remove_file(in(kConfidenceFile));
  } else {
    write_pfm(in(kConfidenceFile), map.confidence);
  }
}

double bytes_to_draw(cv::Size size) {
  // What is shown of the map as it is encoded, and the numbers whose quantiles the colours span,
  // each in a buffer that grows to twice its size; legends are encoded in next to nothing.
  constexpr double kCanvas = 3, kShown = 2 * (3 + sizeof(float));
  return kCanvas * picture_size(size).area() + kShown * Sampling::of_picture(size).shown().area();
}

double bytes_to_write_maps(cv::Size size) { return 2 * bytes_to_draw(size); }

}  // namespace xgm
