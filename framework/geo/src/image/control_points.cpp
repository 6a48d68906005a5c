// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/image/control_points.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"

namespace xgm::geo {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 26;

std::string read_text(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(file + ": there is no such file of control points");
  std::string text;
  for (char c = 0; text.size() < kMaxBytes && stream.get(c);) text += c;
  if (!stream.eof()) throw Error(file + ": cannot be read as a file of control points");
  return text;
}

/// The numbers of an array; empty if it is none, or not all are numbers.
std::vector<double> numbers(const Json* list) {
  std::vector<double> found;
  if (list == nullptr || !list->is_array()) return found;
  for (const Json& number : *list) {
    if (!number.is_number()) return {};
    found.push_back(number.number());
  }
  return found;
}

std::string text_of(const Json& object, const char* key) {
  const Json* const text = object.is_object() ? object.find(key) : nullptr;
  return text != nullptr && text->is_string() ? text->text() : std::string();
}

ControlPoint from_feature(const Json& feature, const std::string& place) {
  const auto member = [](const Json* object, const char* key) {
    return object != nullptr && object->is_object() ? object->find(key) : nullptr;
  };
  const Json* const properties = member(&feature, "properties");
  const std::vector<double> pixel = numbers(member(properties, "ji"));
  const std::vector<double> ground = numbers(member(member(&feature, "geometry"), "coordinates"));
  if (pixel.size() != 2) {
    throw Error(place + " has no property \"ji\" of two numbers, its column and row");
  }
  if (ground.size() != 3) {
    throw Error(place + " has no coordinates [longitude, latitude, height]");
  }
  return {text_of(*properties, "id"),
          text_of(*properties, "filename"),
          {pixel[0], pixel[1]},
          {ground[0], ground[1], ground[2]}};
}

std::vector<ControlPoint> read_geojson(const std::string& file) {
  Json document;
  try {
    document = Json::parse(read_text(file));
  } catch (const Error& error) {
    throw Error(file + ": is no GeoJSON: " + error.message());
  }
  const Json* const features = document.is_object() ? document.find("features") : nullptr;
  if (features == nullptr || !features->is_array()) {
    throw Error(file + ": has no \"features\"; a FeatureCollection of points is wanted");
  }
  std::vector<ControlPoint> points;
  for (const Json& feature : *features) {
    points.push_back(from_feature(feature, file + ": point " + std::to_string(points.size() + 1)));
  }
  return points;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',') {
      fields.emplace_back();
    } else if (c != ' ' && c != '\t' && c != '\r' && c != '"') {
      fields.back() += c;
    }
  }
  return fields;
}

constexpr std::array<const char*, 7> kColumns{"column", "row",   "longitude", "latitude",
                                              "height", "image", "name"};
constexpr std::size_t kNumbers = 5, kImage = 5, kName = 6;

std::vector<ControlPoint> read_csv(const std::string& file) {
  std::istringstream lines(read_text(file));
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = fields_of(line);
  std::array<std::size_t, 7> at{};
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    at[i] = static_cast<std::size_t>(std::ranges::find(header, kColumns[i]) - header.begin());
    if (at[i] == header.size() && i != kName) {
      throw Error(file + ":1: has no column \"" + kColumns[i] +
                  "\"; wanted are image, column, row, longitude, latitude, height");
    }
  }
  std::vector<ControlPoint> points;
  for (int number = 2; std::getline(lines, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::vector<std::string> fields = fields_of(line);
    std::array<double, kNumbers> v{};
    for (std::size_t i = 0; i < kNumbers; ++i) {
      const std::string text = at[i] < fields.size() ? fields[at[i]] : "";
      const auto end = std::from_chars(text.data(), text.data() + text.size(), v[i]);
      if (end.ec != std::errc() || end.ptr != text.data() + text.size()) {
        throw Error(file + ":" + std::to_string(number) + ": \"" + text + "\" is no number for \"" +
                    kColumns[i] + "\"");
      }
    }
    const auto text = [&](std::size_t i) { return at[i] < fields.size() ? fields[at[i]] : ""; };
    points.push_back({text(kName), text(kImage), {v[0], v[1]}, {v[2], v[3], v[4]}});
  }
  return points;
}

void require_sound(const std::string& file, std::vector<ControlPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    ControlPoint& p = points[i];
    if (p.name.empty()) p.name = std::to_string(i + 1);
    const std::string place = file + ": point " + p.name;
    if (p.image.empty()) throw Error(place + " does not say which image shows it");
    const bool on_earth = std::abs(p.ground.longitude) <= 360 &&
                          std::abs(p.ground.latitude) <= 90 && std::abs(p.ground.height) < 1e5;
    if (!on_earth || !std::isfinite(p.pixel.x) || !std::isfinite(p.pixel.y)) {
      throw Error(place + " lies nowhere on the ground; the order is longitude, latitude, height");
    }
  }
}

}  // namespace

std::vector<ControlPoint> read_control_points(const std::string& file) {
  std::vector<ControlPoint> points;
  if (file.ends_with(".geojson") || file.ends_with(".json")) {
    points = read_geojson(file);
  } else if (file.ends_with(".csv")) {
    points = read_csv(file);
  } else {
    throw Error(file + ": control points are read from .geojson, .json and .csv files");
  }
  require_sound(file, points);
  return points;
}

}  // namespace xgm::geo
