// SPDX-License-Identifier: Apache-2.0
// The least that can be registered: a filter that changes nothing.
#pragma once

#include <xgm/plugin.hpp>

namespace {

class Nothing final : public xgm::Filter {
 public:
  struct Parameters {};
  static void describe(Parameters&, xgm::ParameterSet&) {}
  explicit Nothing(Parameters) {}
  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::ImagePair&,
                        const xgm::Context&) const override {
    return map.clone();
  }
};

}  // namespace
