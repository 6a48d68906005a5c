// SPDX-License-Identifier: Apache-2.0
// A cost volume that is there already, as a cost function.
#include "xgm/exchange/answers.hpp"
#include "xgm/exchange/costs.hpp"
#include "xgm/exchange/stored.hpp"
#include "xgm/plugin.hpp"

namespace {

class Precomputed final : public xgm::Cost, public xgm::StatesNeeds {
 public:
  struct Parameters {
    std::string file;
    int first = 0;
    int reverse_first = 0;
    xgm::exchange::CostScale scale;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("file", p.file,
            "NumPy file of the shape (height, width, disparities). {scene} stands for the name of "
            "the scene, {view} for left or right, {scale} for how many times smaller the level of "
            "a pyramid is; relative paths are from where the run was started.");
    set.add("first", p.first, "Disparity of the first number of each pixel.")
        .unit("px")
        .range(-1e6, 1e6);
    set.add("reverse_first", p.reverse_first,
            "The same for the right view, whose disparities have the other sign here.")
        .unit("px")
        .range(-1e6, 1e6);
    xgm::exchange::declare(p.scale, set);
    set.rule({"file"}, "must name a file", [&p] { return !p.file.empty(); });
  }

  explicit Precomputed(Parameters parameters) : p_(std::move(parameters)) {}

  xgm::CostVolume run(const xgm::ImagePair& pair, const xgm::VolumeShapePtr& shape,
                      const xgm::Context& context) const override {
    if (context.run().rehearsal) {
      return xgm::exchange::rehearsed_costs(pair, shape, p_.scale.max_cost);
    }
    return xgm::exchange::read_costs({.name = xgm::exchange::stored_file(p_.file, pair, context),
                                      .first = pair.is_reverse ? p_.reverse_first : p_.first},
                                     pair, shape, p_.scale);
  }

  /// The file, of four bytes to a number.
  xgm::Needs needs(const xgm::Workload& load) const override {
    const double numbers = load.pixels() * load.range.size();
    return {.working = 4 * numbers, .updates = numbers};
  }

 private:
  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Precomputed>("precomputed",
                            "Reads the matching costs of each scene from a NumPy file, as a neural "
                            "network may have written them.");
}
