// SPDX-License-Identifier: Apache-2.0
// A program of the user's as a cost function.
#include "xgm/exchange/answers.hpp"
#include "xgm/exchange/request.hpp"
#include "xgm/plugin.hpp"

namespace {

class External final : public xgm::Cost, public xgm::StatesNeeds {
 public:
  struct Parameters {
    xgm::exchange::Program program;
    xgm::exchange::ImageFiles images = xgm::exchange::ImageFiles::png;
    xgm::exchange::CostScale scale;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    xgm::exchange::declare(p.program, set);
    xgm::exchange::declare(p.images, set);
    xgm::exchange::declare(p.scale, set);
  }

  explicit External(Parameters parameters) : p_(std::move(parameters)) {}

  xgm::CostVolume run(const xgm::ImagePair& pair, const xgm::VolumeShapePtr& shape,
                      const xgm::Context& context) const override {
    if (context.run().rehearsal || shape->hull().empty()) {
      return xgm::exchange::rehearsed_costs(pair, shape, p_.scale.max_cost);
    }
    xgm::exchange::Request question("cost", pair, p_.images, context);
    question.add(range_of(*shape));
    question.run(p_.program);
    return question.costs(pair, shape, p_.scale);
  }

  /// Of this process: the file of the volume, of four bytes to a number. The program has memory of
  /// its own.
  xgm::Needs needs(const xgm::Workload& load) const override {
    const double numbers = load.pixels() * load.range.size();
    return {.working = 4 * numbers + 2 * load.image_bytes(), .updates = numbers};
  }

 private:
  /// All pixels are asked about with all disparities: a volume in a file is dense.
  static xgm::DisparityRange range_of(const xgm::VolumeShape& shape) {
    return xgm::DisparityRange::uniform(shape.size(), shape.hull());
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<External>("external",
                         "Runs a program of yours that computes matching costs; images are handed "
                         "over as files, see docs/external.md.");
}
