// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "xgm/evaluation/evaluation_json.hpp"

using namespace xgm;
using Parsed = nlohmann::ordered_json;

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

TEST_CASE("evaluation JSON: figures keep their last bit") {
  const RegionEvaluation region = some();
  const Evaluation& e = region.evaluation;
  const Parsed json = Parsed::parse(to_json(std::vector{region, region}).dump());
  REQUIRE(json.size() == 2);
  CHECK(json[1]["region"] == region.region);
  CHECK(json[1]["judged_pixels"] == e.judged);
  for (const auto& [name, figure] :
       {std::pair{"invalid", e.invalid}, std::pair{"average_error_px", e.average_error},
        std::pair{"rms_px", e.rms}, std::pair{"a50_px", e.a50}, std::pair{"a90_px", e.a90},
        std::pair{"a95_px", e.a95}, std::pair{"a99_px", e.a99}, std::pair{"d1", e.d1}}) {
    CHECK(json[1][name] == figure);
  }
  REQUIRE(json[1]["thresholds"].size() == e.at.size());
  for (std::size_t i = 0; i < e.at.size(); ++i) {
    const Parsed& score = json[1]["thresholds"][i];
    CHECK(score["delta_px"] == e.at[i].delta);
    CHECK(score["bad"] == e.at[i].bad);
    CHECK(score["total"] == e.at[i].total);
  }
}

TEST_CASE("evaluation JSON: what is not known is null") {
  RegionEvaluation region = some();
  region.evaluation.rms = std::numeric_limits<double>::quiet_NaN();
  CHECK(to_json(region)["rms_px"].is_null());
}
