// SPDX-License-Identifier: Apache-2.0
// Declaration of the parameters of a plugin. Binding, errors, help, schema and docs are derived
// from it.
#pragma once

#include <functional>
#include <initializer_list>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/config/slot_base.hpp"

namespace xgm {

/// Access to an enumeration by the names of its values.
struct Choice {
  std::vector<std::string> names;
  std::function<std::size_t()> get;
  std::function<void(std::size_t)> set;
};

/// One declared parameter. The setters return *this so that a declaration reads as one sentence.
struct XGM_API Field {
  using Target = std::variant<bool*, int*, double*, std::string*, std::vector<double>*,
                              std::vector<std::string>*, Choice, SlotBase*, SlotListBase*>;

  std::string name;
  std::string text;  ///< one sentence for the user
  Target target;
  std::string unit_name;          ///< "px", "grey levels", "" ...
  std::optional<double> minimum;  ///< inclusive
  std::optional<double> maximum;  ///< inclusive
  bool only_odd = false;
  bool only_whole = false;            ///< of a list: its elements
  std::vector<double> choices{};      ///< of a number: if there are any, it is one of them
  std::vector<std::size_t> counts{};  ///< of a list: if there are any, it has so many elements
  bool is_optional = false;           ///< a stage that may be left out
  std::string default_stage_name;     ///< plugin of a stage field that is left out

  Field& unit(std::string name);
  Field& range(double low, double high);                ///< inclusive; for lists: of each element
  Field& odd();                                         ///< integer must be odd
  Field& whole();                                       ///< lists: elements are whole numbers
  Field& one_of(std::initializer_list<double> values);  ///< number: no other values
  Field& elements(std::initializer_list<std::size_t> counts);  ///< list: so many, or so many
  Field& optional();                                           ///< stage fields: may be absent
  Field& default_stage(std::string plugin);
};

/// A relation between parameters ("must not be below p1"), checked after all fields are bound, if
/// the fields it names are valid. The message is shown at the first of `fields`, after its name.
struct Rule {
  std::vector<std::string> fields;
  std::string message;
  std::function<bool()> holds;
};

/// The fields and rules of one Parameters struct, filled in by describe().
class XGM_API ParameterSet {
 public:
  Field& add(std::string name, bool& target, std::string text);
  Field& add(std::string name, int& target, std::string text);
  Field& add(std::string name, double& target, std::string text);
  Field& add(std::string name, std::string& target, std::string text);
  Field& add(std::string name, std::vector<double>& target, std::string text);
  Field& add(std::string name, std::vector<std::string>& target, std::string text);
  Field& add(std::string name, SlotBase& target, std::string text);
  Field& add(std::string name, SlotListBase& target, std::string text);

  template <class Enum>
  Field& add_choice(std::string name, Enum& target, std::string text,
                    std::initializer_list<std::pair<const char*, Enum>> choices) {
    Choice choice;
    std::vector<Enum> values;
    for (const auto& [choice_name, value] : choices) {
      choice.names.emplace_back(choice_name);
      values.push_back(value);
    }
    choice.get = [&target, values] {
      std::size_t i = 0;
      while (i + 1 < values.size() && values[i] != target) ++i;
      return i;
    };
    choice.set = [&target, values](std::size_t i) { target = values[i]; };
    return add_field(std::move(name), std::move(text), std::move(choice));
  }

  /// `holds` may use the named fields only. When it is called, these are bound and in range, and
  /// stages that are not optional are present.
  ///   set.rule({"p2", "p1"}, "must not be below p1", [&p] { return p.p2 >= p.p1; });
  void rule(std::initializer_list<std::string_view> fields, std::string message,
            std::function<bool()> holds);

  const std::list<Field>& fields() const { return fields_; }
  const std::vector<Rule>& rules() const { return rules_; }

 private:
  Field& add_field(std::string name, std::string text, Field::Target target);

  std::list<Field> fields_;  // a list, so that references to fields remain valid
  std::vector<Rule> rules_;
};

}  // namespace xgm
