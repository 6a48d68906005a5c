// SPDX-License-Identifier: Apache-2.0
// Files of disparities and points, read and written.
#include <pybind11/stl.h>

#include <cmath>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "registry.hpp"
#include "requests.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/pfm.hpp"
#include "xgm/io/ply.hpp"
#include "xgm/io/point_cloud.hpp"
#include "xgm/io/scene.hpp"
#include "xgm/io/write_maps.hpp"

namespace xgm::python {
namespace {

py::object read_map_file(const std::string& file, std::optional<double> divisor,
                         const std::vector<double>& no_data) {
  Noted<cv::Mat1f> read = read_disparities(file, divisor, no_data);
  for (const std::string& warning : read.warnings) {
    if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 2) != 0) throw py::error_already_set();
  }
  return to_array(read.value);
}

std::size_t write_cloud(const std::string& file, const py::array& disparity,
                        const std::vector<double>& cameras, const ArrayImage& left, bool is_rgb) {
  if (cameras.size() != 5) throw UsageError("a calibration is focal, cx, cy, doffs, baseline");
  UnscaledImage raster = to_unscaled("left", left, is_rgb);
  const ReadPair read = to_pair(raster, raster);
  return write_point_cloud(file, to_map(disparity),
                           {cameras[0], cameras[1], cameras[2], cameras[3], cameras[4]},
                           read.pair.base);
}

/// The names of the columns, and a row per point.
std::pair<std::vector<std::string>, py::array_t<double>> read_points(const std::string& file) {
  PlyReader reader(file);
  std::vector<std::string> names;
  for (const PlyProperty& property : reader.header().properties) names.push_back(property.name);
  const std::size_t columns = names.size();
  py::array_t<double> points(
      {static_cast<py::ssize_t>(reader.header().count), static_cast<py::ssize_t>(columns)});
  double* row = points.mutable_data();
  {
    const py::gil_scoped_release release;
    while (reader.next({row, columns})) row += columns;
  }
  return {names, points};
}

}  // namespace

void bind_files(py::module_& module) {
  module.def("read_disparities", &read_map_file);
  module.def("write_pfm",
             [](const std::string& file, const py::array& map) { write_pfm(file, to_map(map)); });
  module.def("write_png16", [](const std::string& file, const py::array& levels) {
    write_png(file, cv::Mat1w(to_matrix(levels)));
  });
  module.def("write_maps", [](const std::string& folder, const py::array& disparity,
                              const py::array& status, const std::optional<py::array>& confidence) {
    DisparityMap map = to_disparity_map(disparity, status);
    map.confidence = to_map(confidence);
    write_maps(folder, map);
  });
  module.def("write_cloud", &write_cloud);
  module.def("read_points", &read_points);
  module.def("find_scenes", [](const std::string& folder, const std::string& dataset) {
    return to_json(find_scenes(folder, registry(), dataset));
  });
}

}  // namespace xgm::python
