// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/stage/range_prior.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class Fixed final : public RangePrior {
 public:
  struct Parameters {
    double lowest = 0;
    double highest = 100;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    set.add("lowest", p.lowest, "Lowest ground, above the ellipsoid.").unit("m").range(-500, 9000);
    set.add("highest", p.highest, "Highest ground or roof, above the ellipsoid.")
        .unit("m")
        .range(-500, 9000);
    set.rule({"highest", "lowest"}, "must not be below lowest",
             [&p] { return p.highest >= p.lowest; });
  }

  explicit Fixed(Parameters parameters) : p_(parameters) {}

  HeightInterval heights(const SatelliteImage&, const SatelliteImage&, const cv::Rect&,
                         const HeightField*, const Context&) const override {
    return {p_.lowest, p_.highest};
  }

 private:
  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) { registry.add<Fixed>("fixed", "Disparities of ground between two heights."); }
