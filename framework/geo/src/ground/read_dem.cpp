// SPDX-License-Identifier: Apache-2.0
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "ground/gdal.hpp"
#include "ground/paths.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/ground/dem.hpp"

namespace xgm::geo {
namespace {

namespace fs = std::filesystem;

/// A file of a DEM, and its CRS with heights as far as they are known.
struct Tile {
  std::string file;
  RasterHead head;
};

/// "FILE,DATUM" in its parts.
std::pair<std::string, std::string> split_datum(const std::string& text) {
  if (is_there(text)) return {text, ""};
  const std::size_t comma = text.rfind(',');
  if (comma == std::string::npos) return {text, ""};
  return {text.substr(0, comma), text.substr(comma + 1)};
}

bool is_raster(const std::string& file) {
  GDALAllRegister();
  const QuietGdal quiet;
  return GDALIdentifyDriverEx(file.c_str(), GDAL_OF_RASTER, nullptr, nullptr) != nullptr;
}

/// Of a folder: the rasters in it, by their names.
std::vector<std::string> rasters_of(const std::string& path) {
  if (!is_folder(path)) return {path};
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
    if (entry.is_regular_file() && is_raster(entry.path().string())) {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) throw UsageError(path + ": this folder holds no raster; name the DEM's files");
  return files;
}

/// Metres taken for degrees would be wrapped around the Earth.
void require_degrees(const GridPlace& place, const Crs& crs, const std::string& name) {
  const bool sound = std::abs(place.left) <= 361 && std::abs(place.top) <= 91;
  if (sound || !is_wgs84(crs)) return;
  throw UsageError(name + ": its coordinates (" + std::to_string(place.left) + ", " +
                   std::to_string(place.top) + ") are no degrees, as its CRS " + crs_name(crs) +
                   " has; assign the CRS that they are of (gdal_edit.py -a_srs)");
}

Tile open_tile(const std::string& file, const std::string& datum) {
  Tile tile{file, read_raster_head(file)};
  Crs& crs = tile.head.crs;
  if (crs.empty()) {
    throw UsageError(file + ": this DEM has no CRS; assign one (gdal_edit.py -a_srs)");
  }
  require_degrees(tile.head.place, crs, file);
  crs = datum.empty() ? crs_with_heights(crs, tile.head.metadata)
                      : with_heights(horizontal(crs), datum);
  return tile;
}

/// The cells of a box, and some around it, for heights between cells.
cv::Rect cells_of(const RasterHead& head, const std::optional<DegreeBox>& box) {
  const cv::Rect whole({}, head.size);
  if (!box) return whole;
  constexpr double kAround = 8;
  const cv::Rect2d there = box_in(head.crs, *box);
  const cv::Point2d a = head.place.cell(there.tl()), b = head.place.cell(there.br());
  constexpr double kFar = 1e9;
  const auto cell = [](double value) { return cvRound(std::clamp(value, -kFar / 2, kFar / 2)); };
  return whole &
         cv::Rect(
             cv::Point(cell(std::min(a.x, b.x) - kAround), cell(std::min(a.y, b.y) - kAround)),
             cv::Point(cell(std::max(a.x, b.x) + kAround), cell(std::max(a.y, b.y) + kAround)));
}

/// Where the first cell of `b` lies on the grid of `a`, if both are of one grid.
std::optional<cv::Point> offset_on(const Raster& a, const Raster& b) {
  constexpr double kSlack = 0.01;  // cells
  const auto same = [](double p, double q) { return std::abs(p - q) <= 1e-6 * std::abs(p); };
  if (a.crs != b.crs || !same(a.place.step_x, b.place.step_x) ||
      !same(a.place.step_y, b.place.step_y)) {
    return std::nullopt;
  }
  const cv::Point2d cell = a.place.cell(b.place.centre(0, 0));
  const cv::Point rounded(cvRound(cell.x), cvRound(cell.y));
  if (cv::norm(cell - cv::Point2d(rounded)) > kSlack) return std::nullopt;
  return rounded;
}

/// Whether one raster of both would not be all but empty.
bool lie_close(const cv::Size& first, const cv::Point& offset, const cv::Size& second) {
  constexpr double kMost = 4;
  const double left = std::min(0, offset.x), top = std::min(0, offset.y);
  const double right = std::max(double(first.width), double(offset.x) + second.width);
  const double bottom = std::max(double(first.height), double(offset.y) + second.height);
  const double values = double(first.width) * first.height + double(second.width) * second.height;
  return (right - left) * (bottom - top) <= kMost * values;
}

/// One raster of two of the same grid; values of the first count.
Raster joined(const Raster& first, const Raster& second, const cv::Point& offset) {
  const cv::Rect a({}, first.values.size()), b(offset, second.values.size());
  const cv::Rect all = a | b;
  Raster result{
      cv::Mat1f(all.size(), std::numeric_limits<float>::quiet_NaN()), first.place, first.crs, {}};
  result.place.left += all.x * first.place.step_x;
  result.place.top += all.y * first.place.step_y;
  second.values.copyTo(result.values(b - all.tl()));
  cv::Mat1f here = result.values(a - all.tl());
  first.values.copyTo(here, first.values == first.values);  // where they are numbers
  return result;
}

/// The first of several DEMs that has a height counts.
class Mosaic final : public HeightField {
 public:
  explicit Mosaic(std::vector<std::unique_ptr<const Dem>> parts) : parts_(std::move(parts)) {}
  std::optional<double> height(double longitude, double latitude) const override {
    for (const auto& part : parts_) {
      if (const auto height = part->height(longitude, latitude)) return height;
    }
    return std::nullopt;
  }
  HeightInterval bounds() const override {
    HeightInterval all = parts_.front()->bounds();
    for (const auto& part : parts_) {
      all = {std::min(all.min, part->bounds().min), std::max(all.max, part->bounds().max)};
    }
    return all;
  }
  double posting() const override {
    double finest = parts_.front()->posting();
    for (const auto& part : parts_) finest = std::min(finest, part->posting());
    return finest;
  }

 private:
  std::vector<std::unique_ptr<const Dem>> parts_;
};

struct Part {
  Raster raster;
  std::string name;
};

void add(std::vector<Part>& parts, Raster raster, const std::string& name) {
  for (Part& part : parts) {
    const auto offset = offset_on(part.raster, raster);
    if (offset && lie_close(part.raster.values.size(), *offset, raster.values.size())) {
      part.raster = joined(part.raster, raster, *offset);
      return;
    }
  }
  parts.push_back({std::move(raster), name});
}

[[noreturn]] void refuse(const std::vector<Tile>& tiles, const DegreeBox& box) {
  const Tile& tile = tiles.front();
  const RasterHead& head = tile.head;
  const cv::Point2d a(head.place.left, head.place.top);
  const cv::Point2d b(a.x + head.size.width * head.place.step_x,
                      a.y + head.size.height * head.place.step_y);
  const DegreeBox covered = degrees_of(head.crs, cv::Rect2d(a, b));
  std::string text = tile.file + ": this DEM covers " + to_string(covered) +
                     ", nothing of what the images show (" + to_string(box) + ")";
  if (tiles.size() > 1) text += ", and neither do the other tiles";
  if (intersect(swapped(covered), box)) text += "; its longitudes and latitudes are exchanged";
  throw UsageError(text + "; give a DEM that covers it, or none");
}

/// What PROJ says of a file without knowing it.
template <class Function>
auto named(const std::string& file, const Function& function) {
  try {
    return function();
  } catch (const Error& error) {
    const bool says_it = error.message().find(file) != std::string::npos;
    throw UsageError(says_it ? error.message() : file + ": " + error.message());
  }
}

std::vector<Tile> open_tiles(const std::vector<std::string>& files) {
  std::vector<Tile> tiles;
  for (const std::string& text : files) {
    const auto [path, datum] = split_datum(text);
    for (const std::string& file : rasters_of(path)) {
      tiles.push_back(named(file, [&, &vertical = datum] { return open_tile(file, vertical); }));
    }
  }
  return tiles;
}

}  // namespace

std::string dem_datum(const std::string& text) { return split_datum(text).second; }

std::vector<std::string> dem_files(const std::vector<std::string>& files) {
  std::vector<std::string> all;
  for (const std::string& text : files) {
    for (const std::string& file : rasters_of(split_datum(text).first)) all.push_back(file);
  }
  return all;
}

std::shared_ptr<const HeightField> read_dem(const std::vector<std::string>& files,
                                            const std::optional<DegreeBox>& box) {
  const std::vector<Tile> tiles = open_tiles(files);
  std::vector<Part> parts;
  for (const Tile& tile : tiles) {
    named(tile.file, [&] {
      const cv::Rect cells = cells_of(tile.head, box);
      if (cells.empty()) return;
      Raster raster = read_raster_window(tile.file, cells);
      raster.crs = tile.head.crs;
      add(parts, std::move(raster), tile.file);
    });
  }
  if (parts.empty()) {
    named(tiles.front().file, [&] { refuse(tiles, box.value_or(DegreeBox())); });
  }
  std::vector<std::unique_ptr<const Dem>> dems;
  for (Part& part : parts) {
    dems.push_back(std::make_unique<const Dem>(std::move(part.raster), part.name));
  }
  if (dems.size() == 1) return std::shared_ptr<const Dem>(std::move(dems.front()));
  return std::make_shared<const Mosaic>(std::move(dems));
}

std::shared_ptr<const HeightField> read_dem(const std::string& file) {
  return read_dem(std::vector{file});
}

}  // namespace xgm::geo
