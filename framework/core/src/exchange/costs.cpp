// SPDX-License-Identifier: Apache-2.0
#include "xgm/exchange/costs.hpp"

#include <algorithm>
#include <cmath>

#include "exchange/candidates.hpp"
#include "io/npy.hpp"
#include "xgm/base/error.hpp"
#include "xgm/data/interval_mapping.hpp"

namespace xgm::exchange {
namespace {

std::string text(Interval range) {
  return std::to_string(range.begin) + " to " + std::to_string(range.end - 1);
}

/// A file whose shape is that of a volume.
class Numbers {
 public:
  Numbers(const CostFile& file, const VolumeShape& shape)
      : array_(read_npy(file.name)), is_mirrored_(file.is_mirrored) {
    const auto side = [](int n) { return static_cast<std::size_t>(n); };
    const auto& has = array_.shape;
    if (has.size() != 3 || has[0] != side(shape.height()) || has[1] != side(shape.width())) {
      throw Error(file.name + ": has the shape " + shape_text(has) + ", and (" +
                  std::to_string(shape.height()) + ", " + std::to_string(shape.width()) +
                  ", disparities) is wanted: height and width of the images" +
                  "; tiles, and levels of a pyramid, are smaller than they");
    }
    stored_ = {file.first, file.first + static_cast<int>(has[2])};
    const Interval asked = is_mirrored_ ? reversed(shape.hull()) : shape.hull();
    if (asked.empty() || intersect(asked, stored_) == asked) return;
    throw Error(file.name + ": has the disparities " + text(stored_) + ", and " + text(asked) +
                " are searched; search fewer, or give a file with all of them");
  }

  double at(int y, int x, int d) const {
    const std::size_t columns = array_.shape[1], depth = array_.shape[2];
    const auto own = static_cast<std::size_t>(x);
    const std::size_t column = is_mirrored_ ? columns - 1 - own : own;
    const int disparity = is_mirrored_ ? -d : d;
    return array_.at((static_cast<std::size_t>(y) * columns + column) * depth +
                     static_cast<std::size_t>(disparity - stored_.begin));
  }
  bool is_bytes() const { return array_.type == "u1"; }

 private:
  NpyArray array_;
  bool is_mirrored_;
  Interval stored_{};
};

}  // namespace

void declare(CostScale& scale, ParameterSet& set) {
  set.add("scale", scale.scale,
          "Factor of the numbers of the file, so that costs have 0 to max_cost. Penalties are in "
          "the same unit.")
      .range(1e-6, 1e6);
  set.add("max_cost", scale.max_cost,
          "Larger costs are cut to this; so is what is not known: NaN, or 255 of bytes.")
      .range(1, 254);
}

CostVolume read_costs(const CostFile& file, const ImagePair& pair, const VolumeShapePtr& shape,
                      const CostScale& scale) {
  const Numbers numbers(file, *shape);
  CostVolume costs(shape, scale.max_cost);
  for_each_candidate(pair, costs, [&](int y, int x, int d) {
    const double number = numbers.at(y, x, d);
    if (number < 0) {
      throw Error(file.name + ": holds a negative cost (x " + std::to_string(x) + ", y " +
                  std::to_string(y) + ", disparity " + std::to_string(d) +
                  "); costs are 0 where pixels are alike, and larger where they are not");
    }
    const bool unknown = !std::isfinite(number) || (numbers.is_bytes() && number == 255);
    const double cost = unknown ? scale.max_cost : std::round(scale.scale * number);
    return static_cast<std::uint8_t>(std::min<double>(cost, scale.max_cost));
  });
  return costs;
}

}  // namespace xgm::exchange
