// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/file_layouts/calib_txt.hpp"

#include <cmath>
#include <map>

#include "plugins/dataset/file_layouts/cameras.hpp"
#include "plugins/dataset/file_layouts/faults.hpp"
#include "plugins/dataset/file_layouts/text_file.hpp"
#include "xgm/base/error.hpp"

namespace xgm::dataset {
namespace {

constexpr double kMaxPixels = 1 << 20;

/// "[f 0 cx; 0 f cy; 0 0 1]"
Camera to_camera(const Line& value, const std::string& key) {
  std::string text = value.text;
  const bool bracketed = text.starts_with('[') && text.ends_with(']');
  std::vector<double> m;
  if (bracketed) {
    text = text.substr(1, text.size() - 2);
    for (char& c : text) c = c == ';' ? ' ' : c;
    m = to_numbers(text, value.place, key);
  }
  const auto is = [&](std::size_t i, double number) { return m[i] == number; };
  if (m.size() != 9 || !is(1, 0) || !is(3, 0) || !is(6, 0) || !is(7, 0) || !is(8, 1) ||
      m[0] != m[4] || !(m[0] > 0)) {
    throw Error(value.place + ": " + key + " is \"" + value.text +
                "\"; it must be [f 0 cx; 0 f cy; 0 0 1] with a focal length f above 0");
  }
  return {value.place, key, m[0], m[2], m[5]};
}

int to_count(const Line& value, const std::string& key, const char* of_what) {
  const auto fail = [&] {
    throw Error(value.place + ": " + key + " is \"" + value.text + "\"; it must be a number of " +
                of_what + ", 1 or more");
  };
  double number = 0;
  try {
    number = to_number(value.text, value.place, key);
  } catch (const Error&) {
    fail();
  }
  const bool whole = value.text.find_first_not_of("0123456789") == std::string::npos;
  if (!whole || number < 1 || number > kMaxPixels) fail();
  return static_cast<int>(number);
}

using Values = std::map<std::string, Line>;

Values read_values(const std::string& file) {
  Values values;
  for (const Line& line : read_lines(file)) {
    const std::size_t equals = line.text.find('=');
    if (equals == std::string::npos) continue;
    const std::string key(trimmed(std::string_view(line.text).substr(0, equals)));
    const std::string value(trimmed(std::string_view(line.text).substr(equals + 1)));
    if (!values.emplace(key, Line{line.place, value}).second) {
      throw Error(line.place + ": " + key + " appears twice; keep one of them");
    }
  }
  return values;
}

std::optional<Calibration> to_calibration(const Values& values, std::string& absent) {
  for (const char* key : {"cam0", "doffs", "baseline"}) {
    if (!values.contains(key)) absent += (absent.empty() ? "" : ", ") + std::string(key);
  }
  if (!absent.empty()) return std::nullopt;
  const Camera left = to_camera(values.at("cam0"), "cam0");
  const Line& baseline = values.at("baseline");
  const Line& doffs = values.at("doffs");
  const Calibration calibration{left.focal, left.cx, left.cy,
                                to_number(doffs.text, doffs.place, "doffs"),
                                to_number(baseline.text, baseline.place, "baseline")};
  if (!(calibration.baseline > 0)) {
    throw Error(baseline.place + ": baseline is \"" + baseline.text + "\"; it must be above 0 mm");
  }
  const auto right = values.find("cam1");
  if (right == values.end()) return calibration;
  const Camera other = to_camera(right->second, "cam1");
  require_rectified(left, other);
  const double offset = other.cx - left.cx;
  if (std::abs(offset - calibration.doffs) > 1) {
    throw Error(doffs.place + ": doffs is " + doffs.text + " but cx of cam1 less cx of cam0 is " +
                std::to_string(offset) + "; correct the one that is wrong");
  }
  return calibration;
}

}  // namespace

CalibTxt read_calib_txt(const std::string& file) {
  const Values values = read_values(file);
  CalibTxt result;
  result.calibration = to_calibration(values, result.absent);
  if (const auto ndisp = values.find("ndisp"); ndisp != values.end()) {
    result.disparities = Interval{0, to_count(ndisp->second, "ndisp", "disparities")};
  }
  const auto side = [&](const std::string& key) {
    const auto length = values.find(key);
    return length == values.end() ? 0 : to_count(length->second, key, "pixels");
  };
  result.size = {side("width"), side("height")};
  return result;
}

namespace {

void add(SceneFiles& scene, const std::string& file, const CalibTxt& read) {
  scene.calibration = read.calibration;
  scene.calibrated_size = read.size;
  scene.disparities = read.disparities;
  if (read.disparities) {
    scene.disparities_file = file;
  } else {
    scene.missing.push_back("ndisp in calib.txt: which disparities to search");
  }
  if (!read.absent.empty()) {
    scene.missing.push_back(read.absent +
                            " in calib.txt: the cameras, by which disparities become depths");
  } else if (read.size.width == 0 || read.size.height == 0) {
    scene.missing.push_back(
        "width, height in calib.txt: which size of images it is about, as a check");
  }
}

}  // namespace

void add_calib_txt(SceneFiles& scene, const std::string& file) {
  if (file.empty()) {
    scene.missing.push_back(
        "calib.txt: which disparities to search (ndisp), and the cameras, by "
        "which disparities become depths");
    return;
  }
  scene.calibration_file = file;
  note_fault(scene, file, [&] { add(scene, file, read_calib_txt(file)); });
}

}  // namespace xgm::dataset
