// SPDX-License-Identifier: Apache-2.0
// PFM files: a map that is read, written and read again is the same map.
#include <cmath>
#include <limits>
#include <sstream>

#include "fuzz/support/memory_file.hpp"
#include "fuzz/support/target.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm::fuzz {
namespace {

const testing::TemporaryFolder& folder() {
  static const testing::TemporaryFolder made;
  return made;
}

cv::Size size_in_header(std::string_view input) {
  std::istringstream header{std::string(input)};
  std::string magic;
  cv::Size size;
  header >> magic >> size.width >> size.height;
  return size;
}

bool same(const cv::Mat1f& a, const cv::Mat1f& b) {
  if (a.size() != b.size()) return false;
  for (int y = 0; y < a.rows; ++y) {
    for (int x = 0; x < a.cols; ++x) {
      if (a(y, x) != b(y, x) && !(std::isnan(a(y, x)) && std::isnan(b(y, x)))) return false;
    }
  }
  return true;
}

}  // namespace

void check(std::string_view input) {
  static MemoryFile file;
  file.hold(input);
  std::vector<cv::Mat1f> planes;
  if (!accepts(file.path(), [&] { planes = read_pfm_planes(file.path()); })) return;
  require(planes.size() == 1 || planes.size() == 3, "a PFM has one plane or three");
  for (const cv::Mat1f& plane : planes) {
    require(plane.size() == size_in_header(input), "a plane has the size of the header");
    for (const float value : plane) require(!std::isinf(value), "what is not finite is NaN");
  }
  require(planes.size() * planes.front().total() * sizeof(float) < input.size(),
          "no value comes from nowhere");
  const std::string written = folder() / "again.pfm";
  write_pfm(written, planes.front());
  require(same(read_pfm(written), planes.front()), "a map that is written is read as it was");
}

std::vector<std::string> seeds() {
  cv::Mat1f map(3, 5, 1.5F);
  map(1, 2) = std::numeric_limits<float>::quiet_NaN();
  map(2, 0) = -7;
  const std::string file = folder() / "seed.pfm";
  write_pfm(file, map);
  const std::string colours(12, '\x3f');
  return {read_file(file), "PF 1 1 1.0\n" + colours, "Pf\r\n1 3\r\n-1\r\n" + colours};
}

std::vector<std::string> words() { return {"Pf", "PF", "\n", "-1.0\n", "1048576", "1e-300", "+3"}; }

}  // namespace xgm::fuzz
