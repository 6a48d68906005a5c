// SPDX-License-Identifier: Apache-2.0
// What is tuned over: parsing, points, and values that are mistakes.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "support/temporary_folder.hpp"
#include "xgm/evaluation/tune.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;

namespace {

bool always(const std::vector<Override>&) { return true; }

std::vector<std::string> names(const std::vector<SweepPoint>& points) {
  std::vector<std::string> list;
  for (const SweepPoint& point : points) list.push_back(point.name);
  return list;
}

double number(const Override& value) { return std::strtod(value.value.c_str(), nullptr); }

}  // namespace

TEST_CASE("tune: values and ranges are parsed") {
  const auto parameters =
      parse_tune_parameters({"m.cost=census,zncc", "p1=4..40", "tau=0.5..20", "p2=20..2000:log"});
  REQUIRE(parameters.size() == 4);
  CHECK(parameters[0].values == std::vector<std::string>{"census", "zncc"});
  CHECK(parameters[1].path == "p1");
  CHECK(parameters[1].whole);
  CHECK(parameters[1].low == 4);
  CHECK(parameters[1].high == 40);
  CHECK_FALSE(parameters[2].whole);
  CHECK_FALSE(parameters[2].logarithmic);
  CHECK(parameters[3].logarithmic);
}

TEST_CASE("tune: what is no range is told with the option's name") {
  const auto error = [](const char* text) {
    return error_of([&] { parse_tune_parameters({text}); });
  };
  CHECK(contains(error("p1"), "--over p1: write PATH="));
  CHECK(contains(error("p1=40..4"), "must begin below its end"));
  CHECK(contains(error("p1=1..inf"), "must begin below its end"));
  CHECK(contains(error("p1=0..4:log"), "must begin above 0"));
  CHECK(contains(error("p1=4:log"), "write a range before :log"));
  CHECK(contains(error_of([] { parse_tune_parameters({"a=1,2", "a=3..4"}); }), "given twice"));
}

TEST_CASE("tune: a grid gives each of its points once, in an order that the seed decides") {
  const auto parameters = parse_tune_parameters({"a=1,2,3", "b=x,y"});
  const auto all = names(draw_points(parameters, 100, always, 1));
  CHECK(all.size() == 6);
  CHECK(std::set(all.begin(), all.end()).size() == 6);
  CHECK(all == names(draw_points(parameters, 100, always, 1)));
  CHECK(all != names(draw_points(parameters, 100, always, 2)));
  CHECK(names(draw_points(parameters, 2, always, 1)) == std::vector<std::string>{all[0], all[1]});
}

TEST_CASE("tune: points of ranges lie in them, differ, and reach both ends of whole numbers") {
  const auto parameters = parse_tune_parameters({"a=3..6", "b=0.5..2.0", "c=1..1000:log"});
  const auto points = draw_points(parameters, 200, always, 7);
  CHECK(points.size() == 200);
  std::set<std::string> whole;
  int small = 0;
  for (const SweepPoint& point : points) {
    whole.insert(point.overrides[0].value);
    CHECK(number(point.overrides[1]) >= 0.5);
    CHECK(number(point.overrides[1]) <= 2.0);
    CHECK(number(point.overrides[2]) >= 1);
    CHECK(number(point.overrides[2]) <= 1000);
    if (number(point.overrides[2]) <= 32) ++small;
  }
  CHECK(whole == std::set<std::string>{"3", "4", "5", "6"});
  CHECK(small > 70);  // half of a logarithmic range lies below the root of 1000
  CHECK(small < 130);
}

TEST_CASE("tune: points with which the pipeline is not sound are left out") {
  const auto parameters = parse_tune_parameters({"p1=1..20", "p2=1..20"});
  const auto ordered = [](const std::vector<Override>& point) {
    return number(point[0]) <= number(point[1]);
  };
  const auto points = draw_points(parameters, 50, ordered, 3);
  CHECK(points.size() == 50);
  CHECK(std::ranges::all_of(points, [&](const auto& point) { return ordered(point.overrides); }));
}

TEST_CASE("tune: a value that goes with nothing is a mistake, one that a rule forbids is none") {
  const auto parameters = parse_tune_parameters({"p1=5,20", "p2=10,30", "mode=fast,fsat"});
  const auto is_sound = [](const std::vector<Override>& point) {
    double p1 = 1, p2 = 15;  // as the pipeline is
    for (const Override& value : point) {
      if (value.path == "mode" && value.value != "fast") return false;
      if (value.path == "p1") p1 = number(value);
      if (value.path == "p2") p2 = number(value);
    }
    return p1 <= p2;
  };
  const auto useless = useless_value(parameters, is_sound, 1);
  REQUIRE(useless.size() == 1);
  CHECK(useless[0].path == "mode");
  CHECK(useless[0].value == "fsat");
  CHECK(useless_value({parameters[0], parameters[1]}, is_sound, 1).empty());
}
