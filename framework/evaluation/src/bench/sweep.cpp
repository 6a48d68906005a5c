// SPDX-License-Identifier: Apache-2.0
// Sweeps over parameters, and the names of their points.
#include <algorithm>

#include "bench/point_names.hpp"
#include "xgm/base/error.hpp"
#include "xgm/evaluation/bench.hpp"

namespace xgm {
namespace {

/// At the commas that stand outside of brackets and quotes.
std::vector<std::string> split_values(const std::string& text) {
  std::vector<std::string> values(1);
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{' || c == '(') {
      ++depth;
    } else if (c == ']' || c == '}' || c == ')') {
      --depth;
    } else if (c == ',' && depth == 0) {
      values.emplace_back();
      continue;
    }
    values.back() += c;
  }
  return values;
}

std::string last_key(const std::string& path) { return path.substr(path.rfind('.') + 1); }

void require_once(const Sweep& sweep, const std::vector<Sweep>& all) {
  const auto same = [&](const Sweep& other) { return other.path == sweep.path; };
  if (std::count_if(all.begin(), all.end(), same) == 1) return;
  throw Error("--sweep " + sweep.path + ": is given twice; list all its values in one");
}

}  // namespace

std::string point_name(const std::vector<Override>& values) {
  std::string name;
  for (const Override& value : values) {
    const auto namesakes = std::count_if(values.begin(), values.end(), [&](const auto& other) {
      return last_key(other.path) == last_key(value.path);
    });
    name += "+" + (namesakes == 1 ? last_key(value.path) : value.path) + "=" + value.value;
  }
  return name;
}

Sweep parse_sweep(const std::string& text, const std::string& option) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) {
    throw Error(option + " " + text + ": write PATH=VALUE,VALUE, for example matcher.scale=4,8");
  }
  Sweep sweep{text.substr(0, equals), split_values(text.substr(equals + 1))};
  std::vector<std::string> sorted = sweep.values;
  std::sort(sorted.begin(), sorted.end());
  if (sorted.front().empty()) throw Error(option + " " + text + ": a value is empty");
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    throw Error(option + " " + text + ": the value " + *twice + " is given twice");
  }
  return sweep;
}

std::vector<SweepPoint> sweep_points(const std::vector<Sweep>& sweeps) {
  std::vector<SweepPoint> points(1);
  for (const Sweep& sweep : sweeps) {
    require_once(sweep, sweeps);
    std::vector<SweepPoint> longer;
    for (const SweepPoint& point : points) {
      for (const std::string& value : sweep.values) {
        SweepPoint& next = longer.emplace_back(point);
        next.overrides.push_back({sweep.path, value});
      }
    }
    points = std::move(longer);
  }
  for (SweepPoint& point : points) point.name = point_name(point.overrides);
  return points;
}

}  // namespace xgm
