// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/stage/pairs.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class All final : public Pairs {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit All(Parameters) {}

  std::vector<PairChoice> run(const std::vector<SatelliteImage>& images,
                              const Context&) const override {
    std::vector<PairChoice> pairs;
    for (std::size_t i = 0; i < images.size(); ++i) {
      for (std::size_t j = i + 1; j < images.size(); ++j) pairs.push_back({i, j});
    }
    return pairs;
  }
};

}  // namespace

XGM_PLUGIN(registry) { registry.add<All>("all", "Every image with every later one."); }
