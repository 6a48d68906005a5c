// SPDX-License-Identifier: Apache-2.0
// Where a stage stands in a run, as data: nobody has to read it out of a path.
#pragma once

#include <string>

namespace xgm {

class Stage;

/// Whose pixels a stage works on.
enum class View {
  forward,  ///< those of the run's base image
  reverse,  ///< those of its match image
};

/// "forward", "reverse"
constexpr const char* to_string(View view) { return view == View::forward ? "forward" : "reverse"; }

/// A level of a pyramid. Outside of pyramids the name is empty and the scale 1.
struct Level {
  std::string name;  ///< as the pyramid calls it: "s4"
  double scale = 1;  ///< the run's images are so many times larger; levels in levels multiply
  std::string path;  ///< of the level, which tells levels of several pyramids apart: "matcher.s4"
};

/// One call of a stage. Between stages (in a level, a view) all but path, level and view are those
/// of the stage around.
struct StagePlace {
  std::string path;    ///< slots, levels and views from outside in: "matcher.s4.matcher.cost"
  std::string slot;    ///< the parameter that holds it: "cost", "filters[1]"
  std::string kind;    ///< "cost", "filter"; empty outside of all stages
  std::string plugin;  ///< "census"
  Level level{};
  View view = View::forward;
  int depth = 0;                 ///< number of stages around this one
  const Stage* stage = nullptr;  ///< lives as long as its pipeline
};

}  // namespace xgm
