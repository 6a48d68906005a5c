// SPDX-License-Identifier: Apache-2.0
// What tells a right candidate from a wrong one, in bytes: the one code that forests are trained
// and run with.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "plugins/fuser/candidate_features/maps.hpp"
#include "xgm/base/export.hpp"

namespace xgm::fuser {

/// Raised whenever the meaning of a feature changes: forests that were trained before are refused.
constexpr int kFeatureVersion = 1;

/// The features of a pixel, in this order: those of each matcher (for each cost, then the others),
/// those of each pair of matchers, those of the pixel.
struct FeatureLayout {
  int matchers = 0;
  int costs = 0;

  XGM_API int count() const;
  /// "matcher 1 cost 2, 7x7", ...: one for each feature.
  XGM_API std::vector<std::string> names() const;
};

/// Writes the layout's count() of features. A feature is 0 if it is not known there, else 1 to 255:
/// the greater the value, the greater the byte. The grey levels of masked pixels are not looked at.
void features_at(const CandidateMaps& maps, int y, int x, std::uint8_t* features);

}  // namespace xgm::fuser
