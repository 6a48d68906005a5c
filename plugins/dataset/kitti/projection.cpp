// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/kitti/projection.hpp"

#include <cmath>
#include <optional>

#include "plugins/dataset/file_layouts/cameras.hpp"
#include "plugins/dataset/file_layouts/text_file.hpp"
#include "xgm/base/error.hpp"

namespace xgm::kitti {
namespace {

using dataset::Line;

/// [f 0 cx t; 0 f cy ty; 0 0 1 tz], ty and tz being next to nothing.
struct Projection {
  dataset::Camera camera;
  double shift;  ///< -f * (x of this camera), m * px
};

/// A line "NAME: numbers".
struct Values {
  std::string place, name;
  std::vector<double> numbers;
};

/// The line of one of two names.
std::optional<Values> find(const std::vector<Line>& lines, const std::string& name,
                           const std::string& other) {
  std::optional<Values> found;
  for (const Line& line : lines) {
    const std::size_t colon = line.text.find(':');
    const std::string key = line.text.substr(0, colon);
    if (colon == std::string::npos || (key != name && key != other)) continue;
    if (found) {
      throw Error(line.place + ": " + key + " appears twice, first as " + found->name + " at " +
                  found->place + "; keep one of them");
    }
    found = {line.place, key, dataset::to_numbers(line.text.substr(colon + 1), line.place, key)};
  }
  return found;
}

std::string rect_name(const char* what, int camera) {
  return what + std::string("_rect_0") + std::to_string(camera);
}

Projection find_projection(const std::string& file, const std::vector<Line>& lines, int camera) {
  const std::string name = "P" + std::to_string(camera), rect = rect_name("P", camera);
  const auto found = find(lines, name, rect);
  if (!found) {
    throw Error(file + ": has neither " + name + " nor " + rect +
                "; take the benchmark's own file");
  }
  const std::vector<double>& m = found->numbers;
  if (m.size() != 12 || !(m[0] > 0)) {
    throw Error(found->place + ": " + found->name +
                " must be 12 numbers, the first one a focal length above 0");
  }
  if (m[1] != 0 || m[4] != 0 || m[5] != m[0] || m[8] != 0 || m[9] != 0 || m[10] != 1) {
    throw Error(found->place + ": " + found->name +
                " is no projection of a rectified camera, [f 0 cx tx; 0 f cy ty; 0 0 1 tz]; take "
                "the benchmark's own file");
  }
  return {{found->place, found->name, m[0], m[2], m[6]}, m[3]};
}

cv::Size find_size(const std::vector<Line>& lines, int camera) {
  const std::string name = rect_name("S", camera);
  const auto found = find(lines, name, name);
  if (!found) return {};
  const auto is_side = [](double v) { return v >= 1 && v < 1e6 && v == std::floor(v); };
  if (found->numbers.size() != 2 || !is_side(found->numbers[0]) || !is_side(found->numbers[1])) {
    throw Error(found->place + ": " + name + " must be width and height of the images, px");
  }
  return {static_cast<int>(found->numbers[0]), static_cast<int>(found->numbers[1])};
}

}  // namespace

Cameras read_cameras(const std::string& file, int left, int right) {
  constexpr double kMillimetres = 1000;
  const std::vector<Line> lines = dataset::read_lines(file);
  const Projection l = find_projection(file, lines, left);
  const Projection r = find_projection(file, lines, right);
  dataset::require_rectified(l.camera, r.camera);
  const double baseline = kMillimetres * (l.shift - r.shift) / l.camera.focal;
  if (!(baseline > 0)) {
    throw Error(r.camera.place + ": is not the camera to the right of that in " + l.camera.place +
                "; take the benchmark's own file");
  }
  return {{l.camera.focal, l.camera.cx, l.camera.cy, r.camera.cx - l.camera.cx, baseline},
          find_size(lines, left)};
}

}  // namespace xgm::kitti
