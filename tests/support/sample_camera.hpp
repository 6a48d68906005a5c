// SPDX-License-Identifier: Apache-2.0
// A camera whose 90 numbers all differ.
#pragma once

#include "xgm/geo/camera/rpc_model.hpp"

namespace xgm::testing {

inline geo::RpcModel sample_camera() {
  geo::RpcModel model{.column = {5000.5, 5000},
                      .row = {4000.25, 4000},
                      .longitude = {55.7, 0.0241},
                      .latitude = {-21.2, 0.0226},
                      .height = {1200, 1300},
                      .column_ratio = {},
                      .row_ratio = {}};
  double next = 1;
  for (auto* ratio : {&model.column_ratio, &model.row_ratio}) {
    for (auto* polynomial : {&ratio->numerator, &ratio->denominator}) {
      for (double& value : *polynomial) value = (next *= -0.75);
    }
  }
  return model;
}

}  // namespace xgm::testing
