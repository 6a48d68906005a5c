// SPDX-License-Identifier: Apache-2.0
#include "image/cloud_comments.hpp"

#include <algorithm>
#include <cmath>

#include "xgm/base/scalar.hpp"
#include "xgm/base/text.hpp"
#include "xgm/geo/ground/raster.hpp"

namespace xgm::geo {
namespace {

constexpr std::string_view kCrs = "crs ", kDatum = "vertical_datum ", kResolution = "resolution ",
                           kPair = "pair ", kProjection = "projection: ";
constexpr std::string_view kBetween = " / ";  // names of images are names of files: no slash

/// "EPSG:32740" as s2p says it: "UTM 40S". Other CRS as its later versions do: "CRS EPSG:2154".
std::string s2p_projection(const Crs& crs) {
  const bool is_utm =
      crs.size() == 10 && (crs.starts_with("EPSG:326") || crs.starts_with("EPSG:327"));
  if (!is_utm) return "CRS " + crs;
  return "UTM " + crs.substr(8) + (crs[7] == '6' ? "N" : "S");
}

/// "40S" as "EPSG:32740"; empty for what is no zone.
Crs utm_of(const std::string& zone) {
  if (zone.size() < 2) return {};
  const auto number = to_number<int>(zone.substr(0, zone.size() - 1));
  const bool is_zone =
      number && *number >= 1 && *number <= 60 && (zone.back() == 'N' || zone.back() == 'S');
  if (!is_zone) return {};
  return "EPSG:" + std::to_string((zone.back() == 'N' ? 32600 : 32700) + *number);
}

std::string trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  const std::size_t end = text.find_last_not_of(" \t") + 1;
  return begin < end ? std::string(text.substr(begin, end - begin)) : std::string();
}

/// "0 img_01 / img_02"
void add_pair(std::string_view text, CloudComments& said) {
  const std::size_t names = text.find(' '), between = text.find(kBetween);
  if (names == std::string_view::npos || between == std::string_view::npos || between < names) {
    return;
  }
  const auto number = to_number<std::size_t>(std::string(text.substr(0, names)));
  if (!number) return;
  said.pairs[*number] = {trimmed(text.substr(names, between - names)),
                         trimmed(text.substr(between + kBetween.size()))};
}

void add_projection(const std::string& text, CloudComments& said) {
  if (!said.crs.empty()) return;  // the line "crs" is said more exactly
  if (text.starts_with("UTM ")) said.crs = utm_of(trimmed(text.substr(4)));
  if (text.starts_with("CRS ")) said.crs = trimmed(text.substr(4));
}

}  // namespace

std::vector<std::string> comments_of(const Crs& grid_crs, double resolution,
                                     const std::vector<PointCloud>& pairs) {
  Crs crs = grid_crs;
  std::ranges::replace(crs, '\n', ' ');  // WKT
  std::vector<std::string> comments{"x, y and z in m, by xgm", std::string(kCrs) + crs,
                                    std::string(kProjection) + s2p_projection(crs),
                                    std::string(kDatum) + std::string(kEllipsoidalHeights)};
  if (resolution > 0) {
    comments.push_back(std::string(kResolution) + short_number(resolution));
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    comments.push_back(std::string(kPair) + std::to_string(i) + " " + pairs[i].base +
                       std::string(kBetween) + pairs[i].match);
  }
  return comments;
}

CloudComments understand(const std::vector<std::string>& comments) {
  CloudComments said;
  for (const std::string& comment : comments) {
    const auto value = [&](std::string_view key) {
      return trimmed(std::string_view(comment).substr(key.size()));
    };
    if (comment.starts_with(kCrs)) said.crs = value(kCrs);
    if (comment.starts_with(kDatum)) said.vertical_datum = value(kDatum);
    if (comment.starts_with(kPair)) add_pair(value(kPair), said);
    if (comment.starts_with(kProjection)) add_projection(value(kProjection), said);
    if (!comment.starts_with(kResolution)) continue;
    const double resolution = to_number<double>(value(kResolution)).value_or(0);
    if (std::isfinite(resolution) && resolution > 0) said.resolution = resolution;
  }
  return said;
}

}  // namespace xgm::geo
