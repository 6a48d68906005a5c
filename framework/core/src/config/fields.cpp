// SPDX-License-Identifier: Apache-2.0
#include "config/fields.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <type_traits>

#include "config/meant_number.hpp"
#include "xgm/base/file_names.hpp"
#include "xgm/base/scalar.hpp"
#include "xgm/base/suggest.hpp"

namespace xgm {
namespace {

std::string number(double value) {
  std::ostringstream text;
  text.precision(12);
  text << value;
  return text.str();
}

std::string choices_text(const Field& field) {
  std::vector<std::string> texts;
  for (const double choice : field.choices) texts.push_back(number(choice));
  return "one of " + join(texts);
}

std::string range_text(const Field& field) {
  if (!field.minimum) return "";
  return " from " + number(*field.minimum) + " to " + number(*field.maximum);
}

bool is_allowed(const Field& field, double value) {
  const bool bounded = !field.minimum || (*field.minimum <= value && value <= *field.maximum);
  const bool parity = !field.only_odd || std::fmod(value, 2.0) != 0.0;
  const bool whole = !field.only_whole || value == std::floor(value);
  const bool chosen = field.choices.empty() || std::ranges::count(field.choices, value) > 0;
  return std::isfinite(value) && bounded && parity && whole && chosen;
}

bool may_have(const Field& field, std::size_t elements) {
  return field.counts.empty() || std::ranges::count(field.counts, elements) > 0;
}

// The value of a scalar as T, or nothing. Quoted text is never a number.
template <class T>
std::optional<T> scalar_value(const Node& node) {
  if (!node.is_scalar() || node.quoted) return std::nullopt;
  if constexpr (std::is_same_v<T, bool>) {
    return to_bool(node.scalar);
  } else {
    return to_number<T>(node.scalar);
  }
}

class ValueReader {
 public:
  ValueReader(const Field& field, const Node& node, Diagnostics& diagnostics)
      : field_(field), node_(node), diagnostics_(diagnostics) {}

  bool operator()(bool* target) const {
    const auto value = scalar_value<bool>(node_);
    if (!value) return wrong_type(node_);
    *target = *value;
    return true;
  }
  template <class Number>
  bool operator()(Number* target) const {
    return number_of(node_, *target);
  }
  bool operator()(std::string* target) const {
    if (!node_.is_scalar()) return wrong_type(node_);
    *target = node_.scalar;
    return true;
  }
  bool operator()(std::vector<double>* target) const {
    if (!node_.is_list()) return wrong_type(node_);
    std::vector<double> values(node_.items.size());
    bool good = true;
    for (std::size_t i = 0; i < values.size(); ++i) good &= number_of(node_.items[i], values[i]);
    if (!has_good_count(values.size())) return false;
    if (good) *target = std::move(values);
    return good;
  }
  bool operator()(std::vector<std::string>* target) const {
    if (!node_.is_list()) return wrong_type(node_);
    std::vector<std::string> texts;
    for (const Node& item : node_.items) {
      if (!item.is_scalar()) return wrong_type(item);
      texts.push_back(item.scalar);
    }
    if (!has_good_count(texts.size())) return false;
    *target = std::move(texts);
    return true;
  }
  bool operator()(const Choice& choice) const {
    if (!node_.is_scalar()) return wrong_type(node_);
    const auto found = std::find(choice.names.begin(), choice.names.end(), node_.scalar);
    if (found == choice.names.end()) {
      return diagnose(node_, "'" + field_.name + "' cannot be " + spell(node_),
                      suggest(node_.scalar, choice.names, "choices"));
    }
    choice.set(static_cast<std::size_t>(found - choice.names.begin()));
    return true;
  }
  bool operator()(SlotBase*) const { return false; }
  bool operator()(SlotListBase*) const { return false; }

 private:
  template <class Number>
  bool number_of(const Node& node, Number& target) const {
    const auto value = scalar_value<Number>(node);
    if (!value) return wrong_type(node);
    if (!is_allowed(field_, static_cast<double>(*value))) {
      return diagnose(node,
                      "'" + field_.name + "' cannot be " + number(static_cast<double>(*value)),
                      "give " + expected(field_));
    }
    target = *value;
    return true;
  }
  bool has_good_count(std::size_t elements) const {
    if (may_have(field_, elements)) return true;
    return diagnose(node_,
                    "'" + field_.name + "' cannot have " + std::to_string(elements) +
                        (elements == 1 ? " element" : " elements"),
                    "give " + expected(field_));
  }
  bool wrong_type(const Node& node) const {
    return diagnose(node,
                    "'" + field_.name + "' must be " + expected(field_) + ", not " + spell(node),
                    remedy_for(node));
  }
  /// What to write instead, if the value is one in another spelling.
  std::string remedy_for(const Node& node) const {
    if (node.quoted) return "remove the quotes if a number is meant";
    const std::string word = lower_case(node.scalar);
    if (std::holds_alternative<bool*>(field_.target)) {
      if (word == "yes" || word == "on" || word == "1") return "write true";
      if (word == "no" || word == "off" || word == "0") return "write false";
    } else if (const auto meant = meant_number(word); meant && is_possible(*meant)) {
      return "write " + number(*meant);
    }
    return "change the value";
  }
  bool is_possible(double value) const {
    const bool is_whole = std::holds_alternative<int*>(field_.target);
    return is_allowed(field_, value) && (!is_whole || value == std::floor(value));
  }
  bool diagnose(const Node& node, std::string message, std::string remedy) const {
    add_diagnostic(diagnostics_, node.where, std::move(message), std::move(remedy));
    return false;
  }

  const Field& field_;
  const Node& node_;
  Diagnostics& diagnostics_;
};

struct Expected {
  const Field& field;

  std::string operator()(const bool*) const { return "true or false"; }
  std::string operator()(const int*) const {
    if (!field.choices.empty()) return choices_text(field);
    return std::string(field.only_odd ? "an odd" : "a") + " whole number" + range_text(field);
  }
  std::string operator()(const double*) const {
    return field.choices.empty() ? "a number" + range_text(field) : choices_text(field);
  }
  std::string operator()(const std::string*) const { return "text"; }
  std::string operator()(const std::vector<double>*) const {
    std::string text = "a list of ";
    for (const std::size_t count : field.counts) {
      if (count > 0) text += std::to_string(count) + (count == field.counts.back() ? " " : " or ");
    }
    text += (field.only_whole ? "whole numbers" : "numbers") + range_text(field);
    return may_have(field, 0) && !field.counts.empty() ? text + ", or an empty one" : text;
  }
  std::string operator()(const std::vector<std::string>*) const { return "a list of texts"; }
  std::string operator()(const Choice& choice) const { return "one of " + join(choice.names); }
  std::string operator()(const SlotBase* slot) const {
    return "a stage of kind " + std::string(slot->kind());
  }
  std::string operator()(const SlotListBase* slots) const {
    return "a list of stages of kind " + std::string(slots->kind());
  }
};

}  // namespace

bool is_stage(const Field& field) { return std::holds_alternative<SlotBase*>(field.target); }
bool is_stage_list(const Field& field) {
  return std::holds_alternative<SlotListBase*>(field.target);
}

std::string_view stage_kind(const Field& field) {
  return is_stage(field) ? std::get<SlotBase*>(field.target)->kind()
                         : std::get<SlotListBase*>(field.target)->kind();
}

std::string expected(const Field& field) { return std::visit(Expected{field}, field.target); }

bool bind_value(const Field& field, const Node& node, Diagnostics& diagnostics) {
  return std::visit(ValueReader(field, node, diagnostics), field.target);
}

Json value_of(const Field& field) {
  if (const auto* choice = std::get_if<Choice>(&field.target)) return choice->names[choice->get()];
  return std::visit(
      [](const auto& target) -> Json {
        if constexpr (std::is_pointer_v<std::decay_t<decltype(target)>>) {
          using Value = std::remove_pointer_t<std::decay_t<decltype(target)>>;
          if constexpr (!std::is_abstract_v<Value>) return *target;
        }
        return nullptr;
      },
      field.target);
}

}  // namespace xgm
