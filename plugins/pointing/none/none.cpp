// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/stage/pointing.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class None final : public Pointing {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit None(Parameters) {}

  std::vector<SatelliteImage> run(const std::vector<SatelliteImage>& images,
                                  const std::vector<PairChoice>&, const GroundKnowledge&,
                                  const Context&) const override {
    return images;
  }
};

}  // namespace

XGM_PLUGIN(registry) { registry.add<None>("none", "Cameras as the vendor delivers them."); }
