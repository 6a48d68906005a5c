// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/write_maps.hpp"

#include <filesystem>

#include "xgm/io/image_io.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm {

void write_maps(const std::string& folder, const DisparityMap& map) {
  make_output_folder(folder);
  const std::filesystem::path path(folder);
  write_pfm((path / "disparity.pfm").string(), map.disparity);
  write_png((path / "disparity.png").string(), disparity_picture(map));
  write_png((path / "status.png").string(), status_picture(map));
}

}  // namespace xgm
