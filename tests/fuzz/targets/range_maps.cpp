// SPDX-License-Identifier: Apache-2.0
// Two float images, the halves of the input, that are the search ranges of an image.
#include <cmath>
#include <optional>

#include "fuzz/support/memory_file.hpp"
#include "fuzz/support/target.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/scene.hpp"

namespace xgm::fuzz {
namespace {

void check_pixel(Interval range, float low, float high) {
  const bool has_ends = std::isfinite(low) && std::isfinite(high) && low <= high;
  require(range.empty() != has_ends, "a pixel is searched if and only if it has both ends");
  if (range.empty()) return;
  const auto first = static_cast<float>(range.begin), last = static_cast<float>(range.end - 1);
  require(first == std::floor(low) && last == std::ceil(high), "ends are rounded outwards");
}

}  // namespace

void check(std::string_view input) {
  static MemoryFile low_file, high_file;
  low_file.hold(input.substr(0, input.size() / 2));
  high_file.hold(input.substr(input.size() / 2));
  std::optional<DisparityRange> range;
  const auto read = [&] { range = read_range_maps(low_file.path(), high_file.path()).value; };
  if (!accepts("/proc/self/fd/", read)) return;
  const cv::Mat1f low = read_disparities(low_file.path()).value;
  const cv::Mat1f high = read_disparities(high_file.path()).value;
  require(range->size() == low.size() && range->size() == high.size(), "all have one size");
  require(!range->hull().empty(), "there is a disparity to search");
  for (int y = 0; y < low.rows; ++y) {
    for (int x = 0; x < low.cols; ++x) check_pixel(range->at(y, x), low(y, x), high(y, x));
  }
}

std::vector<std::string> seeds() {
  const std::string header = "Pf\n2 1\n-1.0\n";
  const std::string low("\0\0\xc0\xbf\0\0\0\0", 8);       // -1.5, 0
  const std::string high("\0\0\x80\x3f\0\0\x80\x7f", 8);  // 1, infinite
  return {header + low + header + high, header + low + header + low};
}

std::vector<std::string> words() {
  return {"Pf\n", "2 1\n", "-1.0\n", {"\0\0\x80\x3f", 4}, {"\0\0\x80\x49", 4}};
}

}  // namespace xgm::fuzz
