// SPDX-License-Identifier: Apache-2.0
#include "declared_stage.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <list>

#include "errors.hpp"

namespace xgm::python {
namespace {

/// A value that the binder writes to, and its default.
struct Bound {
  std::string name;
  Value value;
};

void declare(const DeclaredParameter& parameter, Bound& bound, ParameterSet& set) {
  Field& field = std::visit(
      [&](auto& target) -> Field& { return set.add(parameter.name, target, parameter.text); },
      bound.value);
  field.unit(parameter.unit);
  if (parameter.range) field.range(parameter.range->first, parameter.range->second);
  if (parameter.is_odd) field.odd();
  field.counts = parameter.elements;
  if (parameter.choices.empty()) return;
  const std::vector<std::string>& names = parameter.choices;
  field.target = Choice{names,
                        [&bound, names] {
                          const auto found = std::find(names.begin(), names.end(),
                                                       std::get<std::string>(bound.value));
                          return static_cast<std::size_t>(found - names.begin());
                        },
                        [&bound, names](std::size_t i) { bound.value = names[i]; }};
}

class PythonPrototype final : public Prototype {
 public:
  explicit PythonPrototype(std::shared_ptr<const DeclaredStage> declared)
      : declared_(std::move(declared)) {
    for (const DeclaredParameter& parameter : declared_->parameters) {
      declare(parameter, bound_.emplace_back(Bound{parameter.name, parameter.value}), set_);
    }
  }

  ParameterSet& parameters() override { return set_; }

  std::shared_ptr<const Stage> build() override {
    const py::gil_scoped_acquire acquire;
    py::dict values;
    for (const Bound& bound : bound_) values[bound.name.c_str()] = bound.value;
    try {
      return make_python_stage(*declared_, hold((*declared_->make)(**values)));
    } catch (py::error_already_set& raised) {
      throw_as_error(raised, name_of(*declared_));
    }
  }

 private:
  std::shared_ptr<const DeclaredStage> declared_;
  std::list<Bound> bound_;  // a list: fields refer to its elements
  ParameterSet set_;
};

}  // namespace

std::string name_of(const DeclaredStage& declared) {
  return declared.kind + " '" + declared.name + "'";
}

Held hold(py::object object) {
  return {new py::object(std::move(object)), [](py::object* held) {
            const py::gil_scoped_acquire acquire;
            delete held;  // NOLINT(cppcoreguidelines-owning-memory)
          }};
}

PluginInfo to_plugin(DeclaredStage declared) {
  require_python_kind(declared.kind);
  const auto shared = std::make_shared<const DeclaredStage>(std::move(declared));
  return {shared->kind,    shared->name,
          shared->summary, shared->publication,
          shared->origin,  [shared] { return std::make_unique<PythonPrototype>(shared); }};
}

}  // namespace xgm::python
