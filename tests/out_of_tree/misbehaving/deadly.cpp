// SPDX-License-Identifier: Apache-2.0
// Filters that end the process, or never come to an end, when an image has one pixel.
#include <cstdlib>
#include <thread>
#include <xgm/plugin.hpp>

namespace {

[[noreturn]] void crash() { std::abort(); }
[[noreturn]] void leave() { std::_Exit(0); }
[[noreturn]] void hang() {
  while (true) std::this_thread::sleep_for(std::chrono::seconds(1));
}

template <void (*kEnd)()>
class Deadly final : public xgm::Filter {
 public:
  struct Parameters {};
  static void describe(Parameters&, xgm::ParameterSet&) {}
  explicit Deadly(Parameters) {}

  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::ImagePair&,
                        const xgm::Context&) const override {
    if (map.size().area() == 1) kEnd();
    return map.clone();
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Deadly<crash>>("crashes", "Aborts.");
  registry.add<Deadly<leave>>("leaves", "Ends the program as if all was well.");
  registry.add<Deadly<hang>>("hangs", "Never returns.");
}
