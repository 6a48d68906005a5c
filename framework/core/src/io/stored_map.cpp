// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/stored_map.hpp"

#include <algorithm>
#include <filesystem>

#include "io/unscaled_image.hpp"
#include "xgm/base/error.hpp"
#include "xgm/data/fault.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm {
namespace {

std::string disparities_file(const std::string& name) { return name + ".pfm"; }
std::string status_file(const std::string& name) { return name + "_status.png"; }
std::string confidence_file(const std::string& name) { return name + "_confidence.pfm"; }

}  // namespace

std::vector<std::string> write_stored_map(const std::string& folder, const std::string& name,
                                          const DisparityMap& map) {
  const std::filesystem::path path(folder);
  write_pfm((path / disparities_file(name)).string(), map.disparity);
  write_png((path / status_file(name)).string(), map.status);
  std::vector<std::string> files{disparities_file(name), status_file(name)};
  const std::string confidence = confidence_file(name);
  if (map.confidence.empty()) {
    remove_file((path / confidence).string());  // it would be taken for this map's
  } else {
    write_pfm((path / confidence).string(), map.confidence);
    files.push_back(confidence);
  }
  return files;
}

DisparityMap read_stored_map(const std::string& folder, const std::string& name) {
  const std::filesystem::path path(folder);
  const std::string file = (path / status_file(name)).string();
  DisparityMap map;
  map.disparity = read_pfm((path / disparities_file(name)).string());
  const StoredImage stored = read_stored(file);
  const bool is_status = stored.channels.size() == 1 && stored.channels[0].type() == CV_8U &&
                         stored.channels[0].size() == map.disparity.size();
  if (is_status) map.status = stored.channels[0];
  if (!is_status || std::any_of(map.status.begin(), map.status.end(),
                                [](std::uint8_t value) { return value >= kStatusCount; })) {
    throw Error(file + ": does not hold the status of each pixel of " + disparities_file(name) +
                "; remove both, and run again what made them");
  }
  const std::string confidence = (path / confidence_file(name)).string();
  if (std::filesystem::exists(confidence)) {
    map.confidence = read_pfm(confidence);
    if (const auto fault = fault_of_confidence(map.confidence, map.size())) {
      throw Error(confidence + ": " + fault->rule + "; remove it, and run again what made it");
    }
  }
  return map;
}

}  // namespace xgm
