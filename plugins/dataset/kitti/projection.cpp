// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/kitti/projection.hpp"

#include "plugins/dataset/file_layouts/text_file.hpp"
#include "xgm/base/error.hpp"

namespace xgm::kitti {
namespace {

struct Matrix {
  std::string place;
  std::vector<double> m;  // row by row

  double focal() const { return m[0]; }
  double cx() const { return m[2]; }
  double cy() const { return m[6]; }
  double shift() const { return m[3]; }  // -focal * (x of this camera), m * px
};

Matrix find(const std::string& file, const std::vector<dataset::Line>& lines, int camera) {
  const std::string number = std::to_string(camera);
  for (const dataset::Line& line : lines) {
    const std::size_t colon = line.text.find(':');
    const std::string name = line.text.substr(0, colon);
    if (name != "P" + number && name != "P_rect_0" + number) continue;
    Matrix found{line.place, dataset::to_numbers(line.text.substr(colon + 1), line.place, name)};
    if (found.m.size() == 12 && found.focal() > 0) return found;
    throw Error(line.place + ": " + name +
                " must be 12 numbers, the first one a focal length above 0");
  }
  throw Error(file + ": has neither P" + number + " nor P_rect_0" + number +
              "; take the benchmark's own file");
}

}  // namespace

Calibration read_calibration(const std::string& file, int left, int right) {
  constexpr double kMillimetres = 1000;
  const std::vector<dataset::Line> lines = dataset::read_lines(file);
  const Matrix l = find(file, lines, left);
  const Matrix r = find(file, lines, right);
  const double baseline = kMillimetres * (l.shift() - r.shift()) / l.focal();
  if (l.focal() != r.focal() || !(baseline > 0)) {
    throw Error(r.place + ": is not the camera to the right of that in " + l.place +
                "; rectified cameras have one focal length");
  }
  return {l.focal(), l.cx(), l.cy(), r.cx() - l.cx(), baseline};
}

}  // namespace xgm::kitti
