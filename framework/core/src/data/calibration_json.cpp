// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/calibration_json.hpp"

namespace xgm {

Json to_json(const Calibration& cameras) {
  return {{"focal", cameras.focal},
          {"cx", cameras.cx},
          {"cy", cameras.cy},
          {"doffs", cameras.doffs},
          {"baseline", cameras.baseline}};
}

Calibration calibration_of(const Json& json) {
  return {.focal = json.at("focal").number(),
          .cx = json.at("cx").number(),
          .cy = json.at("cy").number(),
          .doffs = json.at("doffs").number(),
          .baseline = json.at("baseline").number()};
}

}  // namespace xgm
