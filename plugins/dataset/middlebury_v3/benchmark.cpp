// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/middlebury_v3/benchmark.hpp"

#include <cmath>
#include <map>
#include <set>

namespace xgm::middlebury_v3 {

double weight(const std::string& scene) {
  static const std::set<std::string> half{"PianoL", "Playroom", "Playtable", "Shelves", "Vintage"};
  return half.contains(scene) ? 0.5 : 1;
}

double scale_of_folder(const std::string& name) {
  if (name.ends_with("trainingQ") || name.ends_with("testQ")) return 4;
  if (name.ends_with("trainingH") || name.ends_with("testH")) return 2;
  if (name.ends_with("trainingF") || name.ends_with("testF")) return 1;
  return 0;
}

double scale_of_width(const std::string& scene, int width) {
  // Full widths in px; a few px more or less make no difference to a factor of two.
  static const std::map<std::string, double> full{
      {"Adirondack", 2880},  {"ArtL", 1390},      {"Jadeplant", 2640},  {"Motorcycle", 2964},
      {"MotorcycleE", 2964}, {"Piano", 2820},     {"PianoL", 2820},     {"Pipes", 2940},
      {"Playroom", 2800},    {"Playtable", 2720}, {"PlaytableP", 2720}, {"Recycle", 2880},
      {"Shelves", 2950},     {"Teddy", 1800},     {"Vintage", 2900}};
  const auto known = full.find(scene);
  if (known == full.end() || width <= 0) return 1;
  const double steps = std::round(std::log2(known->second / width));
  return steps <= 0 ? 1 : steps >= 2 ? 4 : 2;
}

}  // namespace xgm::middlebury_v3
