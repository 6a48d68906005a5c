// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "metrics/evaluation_json.hpp"
#include "support/temporary_folder.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using Json = nlohmann::ordered_json;

namespace {

RegionEvaluation some() {
  RegionEvaluation region{"occluded", {}};
  Evaluation& e = region.evaluation;
  e.judged = 3'000'000'000;
  e.invalid = 1.0 / 3;
  e.average_error = 0.1;
  e.rms = std::sqrt(2.0);
  e.a50 = 1e-300;
  e.a90 = 2;
  e.a95 = 3;
  e.a99 = 1e20;
  e.d1 = 0.7;
  e.at = {{0.5, 1.0 / 7, 1.0 / 3 + 1.0 / 7}, {4, 0, 1.0 / 3}};
  return region;
}

}  // namespace

TEST_CASE("evaluation JSON: what is written is read back to the last bit") {
  const RegionEvaluation before = some();
  const std::string text = to_json(std::vector{before, before}).dump();
  const auto list = evaluations_from_json(Json::parse(text));
  REQUIRE(list.size() == 2);
  const Evaluation &a = before.evaluation, &b = list[1].evaluation;
  CHECK(list[1].region == before.region);
  CHECK(a.judged == b.judged);
  for (double Evaluation::*figure :
       {&Evaluation::invalid, &Evaluation::average_error, &Evaluation::rms, &Evaluation::a50,
        &Evaluation::a90, &Evaluation::a95, &Evaluation::a99, &Evaluation::d1}) {
    CHECK(a.*figure == b.*figure);
  }
  REQUIRE(b.at.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(a.at[i].delta == b.at[i].delta);
    CHECK(a.at[i].bad == b.at[i].bad);
    CHECK(a.at[i].total == b.at[i].total);
  }
}

TEST_CASE("evaluation JSON: what is not known is null, both ways") {
  RegionEvaluation region = some();
  region.evaluation.rms = std::numeric_limits<double>::quiet_NaN();
  const Json json = to_json(region);
  CHECK(json["rms_px"].is_null());
  CHECK(std::isnan(evaluation_from_json(Json::parse(json.dump())).evaluation.rms));
}

TEST_CASE("evaluation JSON: another form is an error") {
  for (const char* text : {"{}", "[]", "3", R"({"region": 4})"}) {
    CHECK(contains(error_of([&] { evaluation_from_json(Json::parse(text)); }), "from JSON"));
  }
  CHECK(contains(error_of([] { evaluations_from_json(Json::object()); }), "not a list"));
}
