// SPDX-License-Identifier: Apache-2.0
#include "explain/plot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "explain/story.hpp"

namespace xgm::explain {
namespace {

constexpr int kColumns = 84;
constexpr std::size_t kLabel = 9;  // characters before the axis

std::string right_aligned(std::string text) {
  text.insert(0, kLabel > text.size() ? kLabel - text.size() : 0, ' ');
  return text;
}

/// The lowest value of each `bin` cells; infinite where none can be matched.
std::vector<float> binned(const std::vector<float>& curve, std::size_t bin) {
  std::vector<float> columns((curve.size() + bin - 1) / bin,
                             std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!std::isnan(curve[i])) columns[i / bin] = std::min(columns[i / bin], curve[i]);
  }
  return columns;
}

std::string axis(std::size_t columns, std::size_t bin, Interval range,
                 const std::vector<Mark>& marks) {
  std::string line(columns, '-');
  for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
    if (!range.contains(mark->disparity)) continue;
    line[static_cast<std::size_t>(mark->disparity - range.begin) / bin] = mark->letter;
  }
  const std::string first = std::to_string(range.begin), last = std::to_string(range.end - 1);
  std::string text = std::string(kLabel, ' ') + " +" + line + "\n";
  text += std::string(kLabel + 2, ' ') + first;
  if (range.size() == 1) return text + "\n";
  const std::size_t used = first.size() + last.size();
  return text + std::string(columns > used ? columns - used : 1, ' ') + last + "\n";
}

}  // namespace

std::string plot(const std::vector<float>& curve, Interval range, const std::vector<Mark>& marks,
                 const std::string& title, int rows) {
  const std::size_t bin = (curve.size() + kColumns - 1) / kColumns;
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (const float value : curve) {
    if (std::isnan(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) return {};
  const std::vector<float> columns = binned(curve, bin);
  std::string text = "  " + title;
  if (bin > 1) text += " (a column shows the lowest of " + std::to_string(bin) + " disparities)";
  text += "\n";
  for (int row = rows - 1; row >= 0; --row) {
    const std::string label = row == rows - 1 ? number(high) : row == 0 ? number(low) : "";
    std::string line = right_aligned(label) + " |";
    for (const float value : columns) {
      const float place = high > low ? (value - low) / (high - low) : 0;
      const bool here =
          std::isfinite(value) && std::lround(place * static_cast<float>(rows - 1)) == row;
      line += here ? '*' : ' ';
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text + axis(columns.size(), bin, range, marks);
}

}  // namespace xgm::explain
