// SPDX-License-Identifier: Apache-2.0
// A stage that Python declares: its parameters, for the registry, and how it is made.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "xgm/plugin/registry.hpp"

namespace xgm::python {
namespace py = pybind11;

using Value = std::variant<bool, int, double, std::string, std::vector<double>>;

struct DeclaredParameter {
  std::string name, text, unit;
  Value value;  ///< the default
  std::optional<std::pair<double, double>> range{};
  bool is_odd = false;
  std::vector<std::string> choices{};   ///< of a text
  std::vector<std::size_t> elements{};  ///< of a list: how many it may have
};

/// A Python object that any thread may let go.
using Held = std::shared_ptr<py::object>;
Held hold(py::object object);

struct DeclaredStage {
  std::string kind, name, summary, publication, origin;
  std::vector<DeclaredParameter> parameters;
  Held make;  ///< from the parameters, by name, to the function that the stage calls
};

/// "filter 'mine'"
std::string name_of(const DeclaredStage& declared);

/// Makes the C++ stage around the function that DeclaredStage::make gave. Throws UsageError if no
/// stages of this kind can be written in Python.
std::shared_ptr<const Stage> make_python_stage(const DeclaredStage& declared, Held function);
void require_python_kind(const std::string& kind);

PluginInfo to_plugin(DeclaredStage declared);

}  // namespace xgm::python
