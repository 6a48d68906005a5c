// SPDX-License-Identifier: Apache-2.0
// A race for programs: every round of it.
#include <opencv2/core/version.hpp>

#include "xgm/base/json.hpp"
#include "xgm/evaluation/speed.hpp"
#include "xgm/plugin/version.hpp"

namespace xgm {
namespace {

constexpr int kFormat = 1;  // raised when a reader would have to change

Json stages_json(const std::vector<StageSeconds>& stages) {
  Json list = Json::array();
  for (const StageSeconds& stage : stages) {
    list.push_back({{"stage", stage.stage},
                    {"median_seconds", median(stage.seconds)},
                    {"seconds", stage.seconds}});
  }
  return list;
}

}  // namespace

std::string speed_json(const SpeedResult& result) {
  Json times = Json::array();
  for (const SpeedTimes& one : result.times) {
    const bool timed = !one.seconds.empty();
    times.push_back({{"name", one.name},
                     {"simd", one.simd.empty() ? Json() : Json(one.simd)},
                     {"median_seconds", timed ? Json(median(one.seconds)) : Json()},
                     {"seconds", one.seconds},
                     {"cpu_seconds", one.cpu_seconds},
                     {"stages", stages_json(one.stages)},
                     {"failure", one.failure.empty() ? Json() : Json(one.failure)}});
  }
  const Json json = {
      {"format", kFormat},
      {"xgm", XGM_VERSION},
      {"opencv", CV_VERSION},
      {"compiler", __VERSION__},
      {"width", result.size.width},
      {"height", result.size.height},
      {"disparities", {{"first", result.disparities.begin}, {"last", result.disparities.end - 1}}},
      {"threads", result.race.threads},
      {"rounds", result.race.rounds},
      {"times", times}};
  return json.dump(2) + "\n";
}

}  // namespace xgm
