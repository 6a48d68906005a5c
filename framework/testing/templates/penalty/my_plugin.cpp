// SPDX-License-Identifier: Apache-2.0
// Penalty "my_plugin": a smaller P2 where the base image is bright.
#include <algorithm>
#include <xgm/plugin.hpp>

namespace {

struct Values {
  int p1 = 24, p2 = 96, p2_bright = 48;
  double bright = 200;
};

/// Two classes of base pixels, one of match pixels.
class Field final : public xgm::PenaltyField {
 public:
  Field(const Values& p, const xgm::Image& base) : p_(p), base_(base), grey_(base.grey()) {}

  xgm::PenaltyTable table(xgm::Direction) const override {
    return {2, 1, {{p_.p1, p_.p2}, {p_.p1, p_.p2_bright}}};
  }
  void classify(xgm::Direction, int y, std::span<std::uint8_t> base,
                std::span<std::uint8_t> match) const override {
    std::fill(match.begin(), match.end(), std::uint8_t{0});
    for (int x = 0; x < grey_.cols; ++x) {
      const bool bright = base_.is_valid(y, x) && grey_(y, x) >= p_.bright;
      base[static_cast<std::size_t>(x)] = bright ? 1 : 0;
    }
  }

 private:
  Values p_;
  xgm::Image base_;
  cv::Mat1f grey_;
};

class MyPlugin final : public xgm::Penalty {
 public:
  using Parameters = Values;
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("p1", p.p1, "Penalty of a disparity step of one.").range(0, 10000);
    set.add("p2", p.p2, "Penalty of a larger step.").range(0, 10000);
    set.add("p2_bright", p.p2_bright, "The same at bright pixels.").range(0, 10000);
    set.add("bright", p.bright, "Grey level from which on a pixel is bright.").range(0, 255);
    set.rule({"p2", "p1"}, "must not be below p1", [&p] { return p.p2 >= p.p1; });
    set.rule({"p2_bright", "p1"}, "must not be below p1", [&p] { return p.p2_bright >= p.p1; });
  }
  explicit MyPlugin(Parameters p) : p_(p) {}

  std::unique_ptr<const xgm::PenaltyField> run(const xgm::ImagePair& pair,
                                               const xgm::Context&) const override {
    return std::make_unique<Field>(p_, pair.base);
  }

 private:
  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MyPlugin>("my_plugin", "Lower penalties where the base image is bright.");
}
