// SPDX-License-Identifier: Apache-2.0
#include "xgm/config/parameters.hpp"

namespace xgm {

SlotBase::~SlotBase() = default;
SlotListBase::~SlotListBase() = default;

Field& Field::unit(std::string unit) {
  unit_name = std::move(unit);
  return *this;
}

Field& Field::range(double low, double high) {
  minimum = low;
  maximum = high;
  return *this;
}

Field& Field::odd() {
  only_odd = true;
  return *this;
}

Field& Field::whole() {
  only_whole = true;
  return *this;
}

Field& Field::one_of(std::initializer_list<double> values) {
  choices = values;
  return *this;
}

Field& Field::elements(std::initializer_list<std::size_t> possible) {
  counts = possible;
  return *this;
}

Field& Field::optional() {
  is_optional = true;
  return *this;
}

Field& Field::default_stage(std::string plugin) {
  default_stage_name = std::move(plugin);
  return *this;
}

Field& ParameterSet::add(std::string name, bool& target, std::string text) {
  return add_field(std::move(name), std::move(text), &target);
}
Field& ParameterSet::add(std::string name, int& target, std::string text) {
  return add_field(std::move(name), std::move(text), &target);
}
Field& ParameterSet::add(std::string name, double& target, std::string text) {
  return add_field(std::move(name), std::move(text), &target);
}
Field& ParameterSet::add(std::string name, std::string& target, std::string text) {
  return add_field(std::move(name), std::move(text), &target);
}
Field& ParameterSet::add(std::string name, std::vector<double>& target, std::string text) {
  return add_field(std::move(name), std::move(text), &target);
}
Field& ParameterSet::add(std::string name, std::vector<std::string>& target, std::string text) {
  return add_field(std::move(name), std::move(text), &target);
}
Field& ParameterSet::add(std::string name, SlotBase& target, std::string text) {
  return add_field(std::move(name), std::move(text), &target);
}
Field& ParameterSet::add(std::string name, SlotListBase& target, std::string text) {
  return add_field(std::move(name), std::move(text), &target);
}

void ParameterSet::rule(std::initializer_list<std::string_view> fields, std::string message,
                        std::function<bool()> holds) {
  rules_.push_back({{fields.begin(), fields.end()}, std::move(message), std::move(holds)});
}

Field& ParameterSet::add_field(std::string name, std::string text, Field::Target target) {
  Field& field = fields_.emplace_back();
  field.name = std::move(name);
  field.text = std::move(text);
  field.target = std::move(target);
  return field;
}

}  // namespace xgm
