// SPDX-License-Identifier: Apache-2.0
// A value of JSON, as records are written and read. The library that prints and parses it is
// included by json.cpp alone: compiling its header takes longer than most of our files.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

/// Null, a boolean, a number, text, an array or an object, whose members keep the order in which
/// they were added. A list in braces is an object if all its elements are pairs {text, value}, else
/// an array: {{"x", 1}, {"y", 2}} is an object, {1, 2} an array.
class XGM_API Json {
 public:
  using Array = std::vector<Json>;
  using Member = std::pair<std::string, Json>;
  using Object = std::vector<Member>;
  using Plain = std::variant<bool, std::int64_t, std::uint64_t, double>;

  Json();
  Json(std::nullptr_t);
  Json(std::same_as<bool> auto value) : Json(Plain(value)) {}
  Json(std::signed_integral auto value) : Json(Plain(std::int64_t{value})) {}
  Json(std::unsigned_integral auto value) requires(!std::same_as<decltype(value), bool>)
      : Json(Plain(std::uint64_t{value})) {}
  Json(std::floating_point auto value) : Json(Plain(double{value})) {}
  Json(const char* text);
  Json(std::string_view text);
  Json(std::string text);
  template <class Element>
  Json(const std::vector<Element>& elements) : Json(array()) {
    for (const Element& element : elements) push_back(element);
  }
  Json(std::initializer_list<Json> list);
  Json(const Json& other);
  Json(Json&& other) noexcept;
  Json& operator=(const Json& other);
  Json& operator=(Json&& other) noexcept;
  ~Json();

  static Json array();
  static Json object();
  /// Throws Error if the text is no JSON, or is nested deeper than any record.
  static Json parse(std::string_view text);
  /// In one line, or with so many blanks before what is one level further in. JSON is UTF-8, file
  /// names may be anything: bytes of text that are no UTF-8 become U+FFFD. Numbers that are not
  /// finite are written as null.
  std::string dump(int indent = -1) const;

  /// The same values of the same types; members in the same order.
  friend bool operator==(const Json& a, const Json& b);

  bool is_null() const { return holds<std::monostate>(); }
  bool is_string() const { return holds<std::string>(); }
  bool is_number() const;
  bool is_array() const { return holds<Array>(); }
  bool is_object() const { return holds<Object>(); }
  bool is_structured() const { return is_array() || is_object(); }
  /// Elements or members; 0 of null, 1 of anything else.
  std::size_t size() const;
  bool empty() const { return size() == 0; }

  /// Values of the type that is_...() tells; anything else throws Error.
  const std::string& text() const;
  double number() const;
  const Plain& plain() const;
  const Array& elements() const;
  const Object& members() const;

  /// The elements of an array; none of anything else.
  Array::const_iterator begin() const;
  Array::const_iterator end() const;

  bool contains(std::string_view key) const { return find(key) != nullptr; }
  /// The member of an object; null if there is none.
  const Json* find(std::string_view key) const;
  /// Throws Error if there is no such member.
  const Json& at(std::string_view key) const;
  /// Of an object, or of null, which becomes one: the member, null if it is new.
  Json& operator[](std::string_view key);
  void erase(std::string_view key);
  /// Takes over all members of another object.
  void update(const Json& other);
  /// Of an array, or of null, which becomes one.
  void push_back(Json element);

 private:
  using Value = std::variant<std::monostate, Plain, std::string, Array, Object>;

  explicit Json(Plain value);
  template <class Held>
  bool holds() const {
    return std::holds_alternative<Held>(value_);
  }

  Value value_;
};

}  // namespace xgm
