// SPDX-License-Identifier: Apache-2.0
#include "jobs/look_json.hpp"

#include <cmath>

namespace xgm::tiles {
namespace {

constexpr const char* kNever = "no_data_above";

Json to_json(const PairLook::View& view) {
  Json json = {{"alpha", view.alpha},
               {"mask_alpha", view.mask_alpha},
               {"no_data", Json(view.marks)},
               {"pixels_without_data", view.masked_pixels}};
  if (std::isfinite(view.never)) json[kNever] = view.never;  // JSON has no infinity
  return json;
}

bool is_true(const Json& json) { return json.dump() == "true"; }

PairLook::View view_of(const Json& json) {
  PairLook::View view{.alpha = is_true(json.at("alpha")),
                      .mask_alpha = is_true(json.at("mask_alpha")),
                      .masked_pixels = json.at("pixels_without_data").number()};
  for (const Json& mark : json.at("no_data")) view.marks.push_back(mark.number());
  if (const Json* never = json.find(kNever)) view.never = never->number();
  return view;
}

}  // namespace

Json to_json(const PairLook& look) {
  return {{"left", to_json(look.left)},
          {"right", to_json(look.right)},
          {"grey_level_offset", look.offset},
          {"grey_level_gain", look.gain}};
}

PairLook look_of(const Json& json) {
  return {.left = view_of(json.at("left")),
          .right = view_of(json.at("right")),
          .offset = json.at("grey_level_offset").number(),
          .gain = json.at("grey_level_gain").number()};
}

}  // namespace xgm::tiles
