// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"

using xgm::Json;
using Other = nlohmann::ordered_json;

TEST_CASE("JSON: values print as they are") {
  CHECK(Json().dump() == "null");
  CHECK(Json(true).dump() == "true");
  CHECK(Json(std::uint8_t{7}).dump() == "7");
  CHECK(Json(std::numeric_limits<std::int64_t>::min()).dump() == "-9223372036854775808");
  CHECK(Json(std::numeric_limits<std::uint64_t>::max()).dump() == "18446744073709551615");
  CHECK(Json(0.1).dump() == "0.1");
  CHECK(Json(2.0).dump() == "2.0");
  CHECK(Json(std::numeric_limits<double>::quiet_NaN()).dump() == "null");
  CHECK(Json("a \"b\"\n").dump() == "\"a \\\"b\\\"\\n\"");
  CHECK(Json(std::vector<std::string>()).dump() == "[]");
  CHECK(Json::object().dump() == "{}");
}

TEST_CASE("JSON: braces are objects if all they hold are pairs with a name, else arrays") {
  CHECK(Json{{"x", 1}, {"y", nullptr}}.dump() == R"({"x":1,"y":null})");
  CHECK(Json{{"only", "one"}}.dump() == R"({"only":"one"})");
  CHECK(Json{1, 2}.dump() == "[1,2]");
  CHECK(Json{"a", "b"}.dump() == R"(["a","b"])");
  CHECK(Json{{1, 2}, {"y", 2}}.dump() == R"([[1,2],["y",2]])");
  CHECK(Json{{"type", {"array", "null"}}}.dump() == R"({"type":["array","null"]})");
}

TEST_CASE("JSON: members keep their order, and texts survive") {
  Json json;
  json["z"] = 1;
  json["a"]["inner"] = {1, 2.5, "ä"};
  json["list"].push_back({{"k", false}});
  json["z"] = "again";
  json.update({{"a", 0}, {"new", Json::array()}});
  json.erase("list");
  const std::string expected = R"({"z":"again","a":0,"new":[]})";
  CHECK(json.dump() == expected);
  CHECK(Json::parse(expected).dump() == expected);
  CHECK(json.dump(2) == Other::parse(expected).dump(2));
}

TEST_CASE("JSON: what is no UTF-8 is replaced") {
  CHECK(Json("\xff").dump() == "\"\xEF\xBF\xBD\"");
}

TEST_CASE("JSON: is read by type and name") {
  const Json json =
      Json::parse(R"({"n": -3, "t": "text", "l": [1, 2], "o": {"k": 0.5}, "b": true})");
  CHECK(json.at("n").number() == -3);
  CHECK(json.at("t").text() == "text");
  CHECK(json.at("l").elements()[1].number() == 2);
  CHECK(json.at("o").members().front().first == "k");
  CHECK(json.at("o").find("none") == nullptr);
  CHECK(json.size() == 5);
  CHECK_FALSE(json.at("b").is_number());
  double sum = 0;
  for (const Json& element : json.at("l")) sum += element.number();
  for (const Json& element : json.at("o")) sum += element.number();  // no array: nothing
  CHECK(sum == 3);
}

TEST_CASE("JSON: what is nested without end is refused, and ends no program") {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  CHECK(Json::parse(nested(150)).dump() == nested(150));
  for (const std::string& text : {nested(1000), nested(1'000'000), std::string(1'000'000, '[')}) {
    CHECK_THROWS_WITH_AS(Json::parse(text), "JSON: nested more than 200 levels deep", xgm::Error);
  }
}

TEST_CASE("JSON: what is not there, or of another type, is an error") {
  const Json json{{"a", 1}};
  CHECK_THROWS_WITH_AS(json.at("b"), "JSON: there is no 'b'", xgm::Error);
  CHECK_THROWS_WITH_AS(json.at("a").text(), "JSON: the value is not text", xgm::Error);
  CHECK_THROWS_AS(Json("text").number(), xgm::Error);
  CHECK_THROWS_AS(Json(1).push_back(2), xgm::Error);
  CHECK_THROWS_AS(Json::parse("{"), xgm::Error);
}
