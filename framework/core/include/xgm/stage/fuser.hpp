// SPDX-License-Identifier: Apache-2.0
// Kind "fuser": which of several matchers is right?
#pragma once

#include <vector>

#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

/// What several matchers found for one view. All maps are of the same size.
struct Candidates {
  std::vector<DisparityMap> maps;    ///< one for each matcher, in their order; at least one
  std::vector<DisparityMap> others;  ///< their maps of the other view; empty where there is none
};

class XGM_API Fuser : public Stage {
 public:
  static constexpr std::string_view kKind = "fuser";
  static constexpr std::string_view kMeaning = "picks among the maps of several matchers";

  /// `pair.base` is the view of the maps. Returns one map, which takes each disparity and its
  /// status from one of the maps at that pixel. It may move it towards others that mean the same
  /// surface, never beyond them.
  virtual DisparityMap run(const Candidates& candidates, const ImagePair& pair,
                           const Context& context) const = 0;

  /// How many matchers it was made for; 0: any number.
  virtual int matchers() const { return 0; }

  /// What every result is looked at for in a run: no disparity is beyond the candidates'.
  static std::optional<Fault> fault_of(const DisparityMap& result, const Candidates& candidates,
                                       const ImagePair& pair, const Context& context);
};

}  // namespace xgm
