// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "image/cloud_comments.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/ground/raster.hpp"
#include "xgm/geo/image/point_cloud.hpp"
#include "xgm/io/ply.hpp"

namespace xgm::geo {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kMostPairs = 65536;

/// The values of a vertex by the names of the properties.
class Vertex {
 public:
  explicit Vertex(const PlyHeader& header) : header_(header), values_(header.properties.size()) {}

  std::span<double> values() { return values_; }
  std::optional<std::size_t> find(std::string_view name) const {
    const auto found = std::ranges::find(header_.properties, name, &PlyProperty::name);
    if (found == header_.properties.end()) return std::nullopt;
    return static_cast<std::size_t>(found - header_.properties.begin());
  }
  double at(std::optional<std::size_t> place, double otherwise) const {
    return place ? values_[*place] : otherwise;
  }

 private:
  const PlyHeader& header_;
  std::vector<double> values_;
};

Crs crs_of(const CloudComments& said, const std::string& file) {
  if (said.crs.empty()) {
    throw UsageError(file +
                     ": does not say its CRS; write a line such as 'comment crs EPSG:32740' into "
                     "its header");
  }
  if (!said.vertical_datum.empty() && said.vertical_datum != kEllipsoidalHeights) {
    throw UsageError(file + ": its heights are above '" + said.vertical_datum +
                     "'; only heights above the ellipsoid are read");
  }
  try {
    if (is_projected(said.crs)) return said.crs;
  } catch (const Error& error) {
    throw UsageError(file + ": " + error.message());
  }
  throw UsageError(file + ": its CRS " + crs_name(said.crs) +
                   " is not projected; give x and y in m");
}

/// The clouds of a file go into those of the same images that were read before.
class PairsOfFile {
 public:
  PairsOfFile(const std::string& file, CloudComments said, CloudSet& clouds)
      : file_(file), said_(std::move(said)), clouds_(clouds) {}

  PointCloud& pair(double number, std::uint64_t point) {
    const bool is_number = number >= 0 && number < kMostPairs && number == std::floor(number);
    if (!is_number) {
      throw Error(file_ + ": point " + std::to_string(point) +
                  ": its pair is no whole number from 0 to 65535");
    }
    const auto index = static_cast<std::size_t>(number);
    const auto known = places_.find(index);
    if (known != places_.end()) return clouds_.pairs[known->second];
    return clouds_.pairs[places_[index] = find(index)];
  }

 private:
  std::size_t find(std::size_t number) {
    const auto named = said_.pairs.find(number);
    PointCloud pair;
    pair.base = file_ + (number > 0 ? " pair " + std::to_string(number) : "");
    if (named != said_.pairs.end()) {
      pair.base = named->second.first;
      pair.match = named->second.second;
    }
    for (std::size_t i = 0; i < clouds_.pairs.size(); ++i) {
      if (clouds_.pairs[i].base == pair.base && clouds_.pairs[i].match == pair.match) return i;
    }
    clouds_.pairs.push_back(std::move(pair));
    return clouds_.pairs.size() - 1;
  }

  std::string file_;
  CloudComments said_;
  CloudSet& clouds_;
  std::map<std::size_t, std::size_t> places_;
};

void read_points(PlyReader& reader, const std::string& file, PairsOfFile pairs) {
  Vertex vertex(reader.header());
  std::array<std::size_t, 3> place{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name(1, "xyz"[i]);
    const auto found = vertex.find(name);
    if (!found) throw Error(file + ": its points have no property '" + name + "'");
    place[i] = *found;
  }
  const auto red = vertex.find("red"), green = vertex.find("green"), blue = vertex.find("blue");
  const auto number = vertex.find("pair"), gap = vertex.find("gap"), source = vertex.find("source");
  for (std::uint64_t point = 1; reader.next(vertex.values()); ++point) {
    const std::span<const double> values = vertex.values();
    const cv::Vec3d where(values[place[0]], values[place[1]], values[place[2]]);
    if (!std::isfinite(where[0]) || !std::isfinite(where[1]) || !std::isfinite(where[2])) continue;
    const double grey = (vertex.at(red, 0) + vertex.at(green, vertex.at(red, 0)) +
                         vertex.at(blue, vertex.at(red, 0))) /
                        3;
    pairs.pair(vertex.at(number, 0), point)
        .add(where, static_cast<float>(grey), static_cast<float>(vertex.at(gap, kUnknown)),
             vertex.at(source, 0) == 1);
  }
}

}  // namespace

CloudSet read_clouds(const std::vector<std::string>& files) {
  CloudSet clouds;
  for (const std::string& file : files) {
    PlyReader reader(file);
    const CloudComments said = understand(reader.header().comments);
    const Crs crs = crs_of(said, file);
    if (clouds.crs.empty()) {
      clouds.crs = crs;
      clouds.resolution = said.resolution;
    }
    if (crs_name(crs) != crs_name(clouds.crs)) {
      throw UsageError(file + ": is in " + crs_name(crs) + ", but " + files.front() + " in " +
                       crs_name(clouds.crs) + "; give clouds of one CRS");
    }
    read_points(reader, file, PairsOfFile(file, said, clouds));
  }
  std::erase_if(clouds.pairs, [](const PointCloud& pair) { return pair.points.empty(); });
  return clouds;
}

}  // namespace xgm::geo
