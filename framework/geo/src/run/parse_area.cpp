// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <string_view>

#include "ground/paths.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/run/surface_files.hpp"

namespace xgm::geo {
namespace {

/// The numbers of a text that has nothing but numbers and these separators between them; else none.
template <class Number>
std::vector<Number> numbers_between(std::string_view text, std::string_view separators) {
  std::vector<Number> found;
  for (std::size_t i = 0; i <= separators.size(); ++i) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    Number value{};
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end.ec != std::errc()) return {};
    found.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end.ptr - text.data()));
    while (text.starts_with(' ')) text.remove_prefix(1);
    if (i == separators.size()) break;
    if (!text.starts_with(separators[i])) return {};
    text.remove_prefix(1);
  }
  return text.empty() ? found : std::vector<Number>{};
}

DegreeBox checked(const DegreeBox& box, const std::string& text) {
  const auto is_latitude = [](double y) { return y >= -90 && y <= 90; };
  if (!is_latitude(box[1]) || !is_latitude(box[3])) {
    const bool exchanged = is_latitude(box[0]) && is_latitude(box[2]);
    throw UsageError("area " + text + ": latitudes lie between -90 and 90 degrees" +
                     (exchanged ? "; write longitudes first: WEST,SOUTH,EAST,NORTH" : ""));
  }
  if (!(box[0] < box[2] && box[1] < box[3])) {
    throw UsageError("area " + text +
                     ": is empty; write WEST,SOUTH,EAST,NORTH with WEST < EAST and SOUTH < NORTH");
  }
  return box;
}

}  // namespace

WantedArea parse_area(const std::string& text) {
  WantedArea area;
  if (text.empty()) return area;
  if (is_there(text)) {
    area.outline = read_outline(text);
    area.box = bounds_of(area.outline);
    return area;
  }
  if (const auto d = numbers_between<double>(text, ",,,"); !d.empty()) {
    area.box = checked({d[0], d[1], d[2], d[3]}, text);
    return area;
  }
  if (const auto p = numbers_between<int>(text, ",:x"); !p.empty()) {
    if (p[0] < 0 || p[1] < 0 || p[2] < 1 || p[3] < 1) {
      throw UsageError("area " + text +
                       ": is no window of an image; columns and rows count from 0");
    }
    area.window = {p[0], p[1], p[2], p[3]};
    return area;
  }
  throw UsageError("area " + text +
                   ": is neither WEST,SOUTH,EAST,NORTH in degrees (55.64,-21.24,55.66,-21.22), nor "
                   "COLUMN,ROW:WIDTHxHEIGHT in pixels of the first image (100,200:1024x1024), nor "
                   "a file that exists");
}

}  // namespace xgm::geo
