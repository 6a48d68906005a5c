// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/stage/range_prior.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class RpcHeights final : public RangePrior {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit RpcHeights(Parameters) {}

  HeightInterval heights(const SatelliteImage& base, const SatelliteImage& match, const cv::Rect&,
                         const HeightField*, const Context&) const override {
    return common_heights(base.camera, match.camera);
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<RpcHeights>("rpc_heights",
                           "Disparities of all heights that the cameras were made for.");
}
