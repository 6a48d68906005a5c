// SPDX-License-Identifier: Apache-2.0
// What parameters may be, and points drawn of it.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "bench/point_names.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/random.hpp"
#include "xgm/base/scalar.hpp"
#include "xgm/base/text.hpp"
#include "xgm/evaluation/tune.hpp"

namespace xgm {
namespace {

constexpr std::size_t kMaxGrid = 4096;  // points that are listed; of more, some are drawn
constexpr int kTries = 64;

struct Range {
  double low, high;
  bool whole;
};

bool is_whole(const std::string& text) { return text.find_first_of(".eE") == std::string::npos; }

/// "4..40"; nothing if that is no range.
std::optional<Range> parse_range(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) return std::nullopt;
  const std::string low = text.substr(0, dots), high = text.substr(dots + 2);
  const auto first = to_number<double>(low), last = to_number<double>(high);
  if (!first || !last) return std::nullopt;
  return Range{*first, *last, is_whole(low) && is_whole(high)};
}

/// The number with so many significant digits, which are the same in every locale.
std::string with_digits(double value, int digits) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

std::string number_text(double value, const TuneParameter& parameter) {
  if (parameter.whole) return std::to_string(std::llround(value));
  constexpr int kDigits = 3;
  const std::string text = with_digits(value, kDigits);
  const double rounded = to_number<double>(text).value_or(value);
  // A rounded number may lie outside of the range; what it was rounded from does not.
  return rounded >= parameter.low && rounded <= parameter.high ? text : short_number(value);
}

std::string draw(const TuneParameter& parameter, Random& random) {
  if (!parameter.values.empty()) {
    const int last = static_cast<int>(parameter.values.size()) - 1;
    return parameter.values[static_cast<std::size_t>(random.integer(0, last))];
  }
  if (parameter.logarithmic) {
    const double exponent = random.real(std::log(parameter.low), std::log(parameter.high));
    return number_text(std::exp(exponent), parameter);
  }
  // Whole numbers are as likely at the ends as elsewhere.
  const double margin = parameter.whole ? 0.4999 : 0;
  return number_text(random.real(parameter.low - margin, parameter.high + margin), parameter);
}

std::vector<Override> draw(const std::vector<TuneParameter>& parameters, Random& random) {
  std::vector<Override> values;
  for (const TuneParameter& parameter : parameters) {
    values.push_back({parameter.path, draw(parameter, random)});
  }
  return values;
}

/// The listed values, or the ends of the range.
std::vector<std::string> tested_values(const TuneParameter& parameter) {
  if (!parameter.values.empty()) return parameter.values;
  return {number_text(parameter.low, parameter), number_text(parameter.high, parameter)};
}

/// Whether some values of the others go with `values[of]`, which is fixed.
bool is_of_use(const std::vector<TuneParameter>& parameters, std::size_t of,
               const std::string& value, const IsSound& is_sound, Random& random) {
  if (is_sound({{parameters[of].path, value}})) return true;
  for (int i = 0; i < kTries && parameters.size() > 1; ++i) {
    std::vector<Override> values = draw(parameters, random);
    values[of].value = value;
    if (is_sound(values)) return true;
  }
  return false;
}

/// Whether all values are listed, and all points of them can be, too.
bool is_small_grid(const std::vector<TuneParameter>& parameters) {
  std::size_t size = 1;
  for (const TuneParameter& parameter : parameters) {
    size *= parameter.values.size();
    if (size == 0 || size > kMaxGrid) return false;
  }
  return true;
}

/// All points of the grid, in an order that the seed decides (Fisher and Yates).
std::vector<SweepPoint> shuffled_grid(const std::vector<TuneParameter>& parameters,
                                      Random& random) {
  std::vector<Sweep> sweeps;
  for (const TuneParameter& parameter : parameters) {
    sweeps.push_back({parameter.path, parameter.values});
  }
  std::vector<SweepPoint> points = sweep_points(sweeps);
  for (std::size_t i = points.size() - 1; i > 0; --i) {
    std::swap(points[i], points[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
  }
  return points;
}

TuneParameter parse(const std::string& text) {
  const Sweep sweep = parse_sweep(text, "--over");
  TuneParameter parameter{.path = sweep.path};
  std::string only = sweep.values.size() == 1 ? sweep.values.front() : "";
  parameter.logarithmic = only.ends_with(":log");
  if (parameter.logarithmic) only.resize(only.size() - 4);
  const auto range = parse_range(only);
  if (!range && parameter.logarithmic) {
    throw Error("--over " + text + ": write a range before :log, for example 4..400:log");
  }
  if (!range) {
    parameter.values = sweep.values;
    return parameter;
  }
  if (!std::isfinite(range->high - range->low) || range->low >= range->high) {
    throw Error("--over " + text + ": the range must begin below its end");
  }
  if (parameter.logarithmic && range->low <= 0) {
    throw Error("--over " + text + ": a range with :log must begin above 0");
  }
  parameter.low = range->low;
  parameter.high = range->high;
  parameter.whole = range->whole;
  return parameter;
}

}  // namespace

std::vector<TuneParameter> parse_tune_parameters(const std::vector<std::string>& texts) {
  std::vector<TuneParameter> parameters;
  for (const std::string& text : texts) {
    const TuneParameter& parameter = parameters.emplace_back(parse(text));
    const auto namesakes = std::ranges::count(parameters, parameter.path, &TuneParameter::path);
    if (namesakes > 1) throw Error("--over " + text + ": the parameter is given twice");
  }
  return parameters;
}

std::vector<Override> useless_value(const std::vector<TuneParameter>& parameters,
                                    const IsSound& is_sound, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    for (const std::string& value : tested_values(parameters[i])) {
      if (!is_of_use(parameters, i, value, is_sound, random)) return {{parameters[i].path, value}};
    }
  }
  return {};
}

std::vector<SweepPoint> draw_points(const std::vector<TuneParameter>& parameters, std::size_t count,
                                    const IsSound& is_sound, std::uint64_t seed) {
  Random random(seed);
  std::vector<SweepPoint> points;
  std::set<std::string> known;
  const auto take = [&](SweepPoint point) {
    if (points.size() < count && known.insert(point.name).second && is_sound(point.overrides))
      points.push_back(std::move(point));
  };
  if (is_small_grid(parameters)) {
    for (SweepPoint& point : shuffled_grid(parameters, random)) take(std::move(point));
    return points;
  }
  for (std::size_t i = 0; i < kTries * count && points.size() < count; ++i) {
    const std::vector<Override> values = draw(parameters, random);
    take({point_name(values), values});
  }
  return points;
}

}  // namespace xgm
