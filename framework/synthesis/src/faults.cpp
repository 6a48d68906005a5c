// SPDX-License-Identifier: Apache-2.0
// The one list of faults: names, texts, strengths, ranges, and where they are kept.
#include "faults.hpp"

#include "xgm/base/error.hpp"
#include "xgm/base/scalar.hpp"
#include "xgm/base/suggest.hpp"
#include "xgm/base/text.hpp"

namespace xgm::synthesis {
namespace {

using F = Faults;

std::vector<FaultKind> list() {
  return {
      {"weak_texture",
       "Parts of the scene have lost a share of their contrast.",
       {{"strength", "", 0.97, 0, 1, [](F& f) -> double& { return f.weak_texture; }},
        {"share of the scene", "", 0.5, 0, 1, [](F& f) -> double& { return f.weak_share; }}}},
      {"repetitive",
       "All surfaces carry the same pattern, repeated; their own texture is what is left.",
       {{"strength", "", 0.95, 0, 1, [](F& f) -> double& { return f.repetitive; }},
        {"period", "px", 12, 2, 1000, [](F& f) -> double& { return f.repetitive_period; }}}},
      {"shadow",
       "Parts of the right view lie in the shade.",
       {{"strength", "", 0.95, 0, 1, [](F& f) -> double& { return f.shadow; }}}},
      {"highlight",
       "Reflections, at other places of the scene in either view.",
       {{"strength", "", 1.5, 0, 10, [](F& f) -> double& { return f.highlight; }}}},
      {"blur",
       "The right view is out of focus.",
       {{"standard deviation", "px", 2, 0, 50, [](F& f) -> double& { return f.blur; }}}},
      {"vignetting",
       "Both views darken towards their corners.",
       {{"strength", "", 0.97, 0, 1, [](F& f) -> double& { return f.vignetting; }}}},
      {"exposure",
       "The right view is exposed so many times longer, and raised.",
       {{"factor", "", 2, 0.001, 100, [](F& f) -> double& { return f.exposure; }},
        {"bias", "grey levels", 0, -255, 255, [](F& f) -> double& { return f.bias; }}}},
      {"noise",
       "Both sensors are noisy.",
       {{"standard deviation", "grey levels", 12, 0, 255,
         [](F& f) -> double& { return f.noise; }}}},
      {"gamma",
       "The right view has another tone curve.",
       {{"exponent", "", 4, 0.05, 20, [](F& f) -> double& { return f.gamma; }}}},
      {"vertical",
       "Rows of the right view are shifted by a x + b y + c.",
       {{"a", "px per px", 0, -0.9, 0.9, [](F& f) -> double& { return f.vertical.a; }},
        {"b", "px per px", 0.01, -0.9, 0.9, [](F& f) -> double& { return f.vertical.b; }},
        {"c", "px", 1.3, -100000, 100000, [](F& f) -> double& { return f.vertical.c; }}}},
  };
}

void check(const FaultKind& kind, const FaultValue& value, double number) {
  if (number >= value.minimum && number <= value.maximum) return;
  throw Error("fault " + kind.name + ": the " + value.name + " is " + short_number(number) +
              "; give a number from " + short_number(value.minimum) + " to " +
              short_number(value.maximum) + (value.unit.empty() ? "" : " (" + value.unit + ")"));
}

const FaultKind& find(const std::string& name) {
  std::vector<std::string> names;
  for (const FaultKind& kind : fault_kinds()) {
    if (kind.name == name) return kind;
    names.push_back(kind.name);
  }
  throw Error("there is no fault '" + name + "'; " + suggest(name, names, "there are"));
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

}  // namespace

const std::vector<FaultKind>& fault_kinds() {
  static const std::vector<FaultKind> kinds = list();
  return kinds;
}

void plant(Faults& faults, const std::string& fault) {
  const std::size_t equals = fault.find('=');
  const FaultKind& kind = find(fault.substr(0, equals));
  std::vector<std::string> given;
  if (equals != std::string::npos) given = split(fault.substr(equals + 1));
  if (given.size() > kind.values.size())
    throw Error("fault " + kind.name + " has " + std::to_string(kind.values.size()) +
                " values at most, not " + std::to_string(given.size()) + "; leave some out");
  for (std::size_t i = 0; i < kind.values.size(); ++i) {
    const FaultValue& value = kind.values[i];
    double number = value.planted;
    if (i < given.size()) {
      const auto parsed = to_number<double>(given[i]);
      if (!parsed)
        throw Error("fault " + kind.name + ": the " + value.name + " is '" + given[i] +
                    "'; give a number, as in " + kind.name + "=" + short_number(value.planted));
      number = *parsed;
    }
    check(kind, value, number);
    value.in(faults) = number;
  }
}

void check(const Faults& faults) {
  Faults copy = faults;
  for (const FaultKind& kind : fault_kinds())
    for (const FaultValue& value : kind.values) check(kind, value, value.in(copy));
}

}  // namespace xgm::synthesis
