// SPDX-License-Identifier: Apache-2.0
#include "xgm/base/json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "xgm/base/error.hpp"

namespace xgm {
namespace {

using Library = nlohmann::ordered_json;

// Values are walked by recursion. A record holds a pipeline, which is nested 100 deep at most.
constexpr int kDeepest = 200;

template <class Held>
const Held& require(const Held* held, const std::string& what) {
  if (held == nullptr) throw Error("JSON: the value is not " + what);
  return *held;
}

/// An array or an object that may still be null.
template <class Held, class Value>
Held& become(Value& value, const std::string& what) {
  if (std::holds_alternative<std::monostate>(value)) value = Held();
  require(std::get_if<Held>(&value), what);
  return std::get<Held>(value);
}

Library to_library(const Json& json) {
  Library result;
  if (json.is_array()) {
    result = Library::array();
    for (const Json& element : json.elements()) result.push_back(to_library(element));
  } else if (json.is_object()) {
    result = Library::object();
    for (const auto& [key, value] : json.members()) result.emplace(key, to_library(value));
  } else if (json.is_string()) {
    result = json.text();
  } else if (!json.is_null()) {
    std::visit([&](const auto& value) { result = value; }, json.plain());
  }
  return result;
}

Json from_library(const Library& library) {
  switch (library.type()) {
    case Library::value_t::boolean:
      return library.get<bool>();
    case Library::value_t::number_integer:
      return library.get<std::int64_t>();
    case Library::value_t::number_unsigned:
      return library.get<std::uint64_t>();
    case Library::value_t::number_float:
      return library.get<double>();
    case Library::value_t::string:
      return library.get_ref<const std::string&>();
    default:
      break;
  }
  Json json;
  if (library.is_array()) {
    json = Json::array();
    for (const Library& element : library) json.push_back(from_library(element));
  } else if (library.is_object()) {
    json = Json::object();
    for (const auto& [key, value] : library.items()) json[key] = from_library(value);
  }
  return json;
}

bool is_member(const Json& json) {
  return json.is_array() && json.size() == 2 && json.elements().front().is_string();
}

}  // namespace

Json::Json() = default;
Json::Json(std::nullptr_t) {}
Json::Json(Plain value) : value_(value) {}
Json::Json(const char* text) : value_(std::string(text)) {}
Json::Json(std::string_view text) : value_(std::string(text)) {}
Json::Json(std::string text) : value_(std::move(text)) {}
Json::Json(std::initializer_list<Json> list) {
  if (std::all_of(list.begin(), list.end(), is_member)) {
    Object& members = become<Object>(value_, "an object");
    for (const Json& pair : list) {
      members.emplace_back(pair.elements()[0].text(), pair.elements()[1]);
    }
  } else {
    value_ = Array(list);
  }
}
Json::Json(const Json& other) = default;
Json::Json(Json&& other) noexcept = default;
Json& Json::operator=(const Json& other) = default;
Json& Json::operator=(Json&& other) noexcept = default;
Json::~Json() = default;

bool operator==(const Json& a, const Json& b) { return a.value_ == b.value_; }

Json Json::array() {
  Json json;
  json.value_ = Array();
  return json;
}

Json Json::object() {
  Json json;
  json.value_ = Object();
  return json;
}

Json Json::parse(std::string_view text) {
  const auto require_depth = [](int depth, Library::parse_event_t, const Library&) {
    if (depth > kDeepest) {
      throw Error("JSON: nested more than " + std::to_string(kDeepest) + " levels deep");
    }
    return true;
  };
  try {
    return from_library(Library::parse(text, require_depth));
  } catch (const Library::exception& failure) {
    throw Error(failure.what());
  }
}

std::string Json::dump(int indent) const {
  return to_library(*this).dump(indent, ' ', false, Library::error_handler_t::replace);
}

bool Json::is_number() const {
  const auto* plain = std::get_if<Plain>(&value_);
  return plain != nullptr && !std::holds_alternative<bool>(*plain);
}

std::size_t Json::size() const {
  if (is_array()) return elements().size();
  if (is_object()) return members().size();
  return is_null() ? 0 : 1;
}

const Json::Plain& Json::plain() const {
  return require(std::get_if<Plain>(&value_), "a number or a boolean");
}

const std::string& Json::text() const { return require(std::get_if<std::string>(&value_), "text"); }

double Json::number() const {
  if (!is_number()) throw Error("JSON: the value is not a number");
  return std::visit([](auto value) { return static_cast<double>(value); }, plain());
}

const Json::Array& Json::elements() const {
  return require(std::get_if<Array>(&value_), "an array");
}

const Json::Object& Json::members() const {
  return require(std::get_if<Object>(&value_), "an object");
}

Json::Array::const_iterator Json::begin() const {
  static const Array kNone;
  return is_array() ? elements().begin() : kNone.begin();
}

Json::Array::const_iterator Json::end() const { return is_array() ? elements().end() : begin(); }

const Json* Json::find(std::string_view key) const {
  if (!is_object()) return nullptr;
  for (const auto& [name, value] : members()) {
    if (name == key) return &value;
  }
  return nullptr;
}

const Json& Json::at(std::string_view key) const {
  const Json* const found = find(key);
  if (found == nullptr) throw Error("JSON: there is no '" + std::string(key) + "'");
  return *found;
}

Json& Json::operator[](std::string_view key) {
  Object& members = become<Object>(value_, "an object");
  for (auto& [name, value] : members) {
    if (name == key) return value;
  }
  return members.emplace_back(key, Json()).second;
}

void Json::erase(std::string_view key) {
  std::erase_if(become<Object>(value_, "an object"),
                [&](const Member& member) { return member.first == key; });
}

void Json::update(const Json& other) {
  for (const auto& [key, value] : other.members()) (*this)[key] = value;
}

void Json::push_back(Json element) {
  become<Array>(value_, "an array").push_back(std::move(element));
}

}  // namespace xgm
