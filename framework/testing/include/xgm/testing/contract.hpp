// SPDX-License-Identifier: Apache-2.0
// What every stage of a kind owes the rest of the pipeline, as checks for the tests of any plugin.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/stage/aggregation.hpp"
#include "xgm/stage/confidence.hpp"
#include "xgm/stage/consistency.hpp"
#include "xgm/stage/cost.hpp"
#include "xgm/stage/dataset.hpp"
#include "xgm/stage/filter.hpp"
#include "xgm/stage/fuser.hpp"
#include "xgm/stage/matcher.hpp"
#include "xgm/stage/penalty.hpp"
#include "xgm/stage/pipeline.hpp"
#include "xgm/stage/preprocess.hpp"
#include "xgm/stage/refinement.hpp"
#include "xgm/stage/search_range.hpp"
#include "xgm/stage/selection.hpp"

namespace xgm::testing {

/// One sentence for each broken rule: the input it was broken on, the rule, the first pixel. Empty
/// means that the stage keeps its contract. Exceptions of the stage are violations too: all inputs
/// are ones that a pipeline may produce.
using Violations = std::vector<std::string>;

/// Told of each check, an input that a stage is tried on, while a contract is looked at.
struct Watch {
  std::function<void(const std::string& check)> begin = [](const std::string&) {};
  /// With the rules that were broken.
  std::function<void(const Violations&)> end = [](const Violations&) {};
  /// Whether checks are told and not made.
  bool only_names = false;
};

// What runs look at, too (see the kinds' fault_of()), is part of each contract. Common to all
// kinds: inputs are left as they are; the result has the same bytes for 1, 2, 3 and 8
// threads; images of one pixel, one row, one column or without any data are no reason to fail; the
// grey levels of masked pixels never matter.

/// The base keeps its size and the match image has it too; masked base pixels stay masked; levels
/// are finite where pixels are valid.
XGM_API Violations check_preprocess(const Preprocess& stage, const Watch& watch = {});

/// Both maps have the image's size and keep DisparityMap's invariant; matched disparities lie less
/// than a pixel outside of the range searched (ranges: usual, negative, wider than the image,
/// empty; per-pixel ones if accepted); exactly the masked pixels are masked; most matches of an
/// easy scene are right.
XGM_API Violations check_matcher(const Matcher& stage, const Watch& watch = {});

/// Cells are kNoMatch exactly where the candidate is outside or masked, else at most max_cost; the
/// shape is the one given; a cell does not depend on which other cells there are.
XGM_API Violations check_cost(const Cost& stage, const Watch& watch = {});

/// Tables have all their entries, 0 <= p1 <= p2; classes are in range and do not depend on the
/// order in which rows are asked for.
XGM_API Violations check_penalty(const Penalty& stage, const Watch& watch = {});

/// Sums are kNoMatch exactly where costs are; cells that are missing and cells that are kNoMatch
/// make no difference to others (if ragged volumes are accepted), up to a constant per pixel.
XGM_API Violations check_aggregation(const Aggregation& stage, const Watch& watch = {});

/// Disparities are whole, in the pixel's range, and not of a kNoMatch cell; out_of_range exactly
/// where no cell can match.
XGM_API Violations check_selection(const Selection& stage, const Watch& watch = {});

/// Moves disparities by at most half a pixel and changes no status.
XGM_API Violations check_refinement(const Refinement& stage, const Watch& watch = {});

/// Keeps size, invariant and masked pixels; a missing pixel takes no others with it; works for the
/// maps of either view.
XGM_API Violations check_filter(const Filter& stage, const Watch& watch = {});

/// No disparity lies beyond the candidates'; exactly the masked pixels are masked; maps that are
/// all the same stay as they are.
XGM_API Violations check_fuser(const Fuser& stage, const Watch& watch = {});

/// Takes pixels away as occluded or mismatched and changes nothing else; keeps maps that agree.
XGM_API Violations check_consistency(const Consistency& stage, const Watch& watch = {});

/// 0 to 1 or NaN, and NaN where there is no disparity, of the evidence that it says it needs.
XGM_API Violations check_confidence(const Confidence& stage, const Watch& watch = {});

/// Has the size of the limits; leaves something to search wherever the limits do; the range around
/// a flat coarse map holds twice its disparity.
XGM_API Violations check_search_range(const SearchRange& stage, const Watch& watch = {});

/// Finds no scene in an empty folder, nor in one with other things; an Error that names the path
/// for one that is not there and for a file; says what it looks for.
XGM_API Violations check_dataset(const Dataset& stage, const Watch& watch = {});

/// Of a family of stereo pipelines: what is owed by a matcher.
XGM_API Violations check_pipeline(const StereoFamily& stage, const Watch& watch = {});

/// The check of the kind that the stage is of.
XGM_API Violations check_stage(const Stage& stage, const Watch& watch = {});

}  // namespace xgm::testing
