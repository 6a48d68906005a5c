// SPDX-License-Identifier: Apache-2.0
// The differences of two runs as lines of text.
#include "xgm/base/text.hpp"

#include "xgm/evaluation/run_diff.hpp"

namespace xgm {
namespace {

void add_part(const std::string& title, const std::vector<Difference>& differences,
              std::string& text) {
  if (differences.empty()) return;
  text += title + ":\n";
  for (const Difference& difference : differences) {
    text += "  " + difference.what + ": " + difference.first + " -> " + difference.second + "\n";
  }
}

std::string share(std::int64_t count, std::int64_t of) {
  constexpr double kPercent = 100;
  const double value = of > 0 ? kPercent * static_cast<double>(count) / static_cast<double>(of) : 0;
  return std::to_string(count) + " px (" + fixed_number(value, 3) + " %)";
}

std::string place_text(const cv::Rect& place) {
  return "x " + std::to_string(place.x) + " to " + std::to_string(place.br().x - 1) + ", y " +
         std::to_string(place.y) + " to " + std::to_string(place.br().y - 1);
}

void add_counts(const std::string& title, const MapDifference& map, std::string& text) {
  text += title + ":\n  differing: " + share(map.differing(), map.pixels) + ", in " +
          place_text(map.box) + "\n";
}

void add_confidence(const MapDifference& confidence, std::string& text) {
  if (confidence.differing() == 0) return;
  add_counts("confidence", confidence, text);
  text += "  of pixels with both: mean difference " + fixed_number(confidence.mean, 6) +
          ", largest " + fixed_number(confidence.largest, 4) + "\n";
}

void add_map(const MapDifference& map, std::string& text) {
  if (map.differing() == 0) return;
  add_counts("map", map, text);
  text += "  moved: " + share(map.moved, map.pixels) +
          ", only in the first: " + share(map.only_first, map.pixels) +
          ", only in the second: " + share(map.only_second, map.pixels) + "\n";
  text += "  of disparities in both: mean difference " + fixed_number(map.mean, 4) +
          " px, largest " + fixed_number(map.largest, 2) + " px\n";
  for (const DifferentPlace& place : map.worst) {
    text += "  worst: " + place_text(place.square) + ": " +
            share(place.pixels, place.square.area()) + ", by at most " +
            fixed_number(place.largest, 2) + " px\n";
  }
}

}  // namespace

std::string diff_text(const RunDiff& diff) {
  std::string text;
  add_part("files", diff.files, text);
  add_part("configuration", diff.configuration, text);
  add_part("program", diff.program, text);
  add_part("inputs", diff.inputs, text);
  add_part("map", diff.map_size, text);
  if (diff.map) add_map(*diff.map, text);
  if (diff.confidence) add_confidence(*diff.confidence, text);
  for (const std::string& note : diff.notes) text += "note: " + note + "\n";
  if (!diff.same()) add_part("figures, which count for nothing", diff.figures, text);
  return text + (diff.same() ? "the runs are the same\n" : "the runs differ\n");
}

}  // namespace xgm
