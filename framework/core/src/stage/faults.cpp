// SPDX-License-Identifier: Apache-2.0
// The rules of each kind that can be told from inputs and result at the cost of a look at each
// pixel: what would mislead the next stage, or whoever reads the map.
#include <algorithm>
#include <cmath>
#include <functional>

#include "data/first_pixel.hpp"
#include "xgm/data/interval_mapping.hpp"
#include "xgm/stage/aggregation.hpp"
#include "xgm/stage/confidence.hpp"
#include "xgm/stage/consistency.hpp"
#include "xgm/stage/cost.hpp"
#include "xgm/stage/dataset.hpp"
#include "xgm/stage/filter.hpp"
#include "xgm/stage/fuser.hpp"
#include "xgm/stage/matcher.hpp"
#include "xgm/stage/pipeline.hpp"
#include "xgm/stage/preprocess.hpp"
#include "xgm/stage/refinement.hpp"
#include "xgm/stage/search_range.hpp"
#include "xgm/stage/selection.hpp"

namespace xgm {
namespace {

using MaybeFault = std::optional<Fault>;

/// `rule` if any pixel is broken; see first_pixel().
template <class Broken>
MaybeFault fault_if(const char* rule, cv::Size size, const Broken& broken) {
  const auto pixel = first_pixel(size, broken);
  return pixel ? MaybeFault(Fault{rule, pixel}) : std::nullopt;
}

bool has_disparity_at(const std::uint8_t* status, int x) {
  return has_disparity(static_cast<Status>(status[x]));
}

/// Of a disparity that lies in a range. Floats of this size have no fractions; std::floor would be
/// called for each pixel.
bool is_whole(float disparity) {
  constexpr float kNoFractions = 3 << 22;
  return (disparity + kNoFractions) - kNoFractions == disparity;
}

MaybeFault fault_of_matched(const DisparityMap& map, const Image& view, Interval searched) {
  if (auto fault = fault_of(map, {view.size(), searched})) return fault;
  if (view.valid.empty()) return std::nullopt;
  return fault_if("a pixel without data has a disparity", map.size(), [&](int y) {
    return [status = map.status[y], valid = view.valid[y]](int x) {
      return static_cast<bool>((valid[x] == 0) & has_disparity_at(status, x));
    };
  });
}

MaybeFault fault_of_kept(const DisparityMap& checked, const DisparityMap& map) {
  if (auto fault = fault_of(checked, {map.size()})) return fault;
  return fault_if("a disparity was added or changed", map.size(), [&](int y) {
    return [now = checked.disparity[y], before = map.disparity[y], status = checked.status[y],
            status_before = map.status[y]](int x) {
      const bool same = static_cast<bool>((now[x] == before[x]) & (status[x] == status_before[x]));
      return static_cast<bool>(has_disparity_at(status, x) & !same);
    };
  });
}

}  // namespace

MaybeFault Dataset::fault_of(const std::vector<SceneFiles>& scenes) {
  for (const SceneFiles& scene : scenes) {
    const std::string of_scene = " of scene '" + scene.name + "' ";
    const TruthFiles& truth = scene.truth;
    if (scene.name.empty()) return Fault{"a scene has no name"};
    if (scene.disparities && scene.disparities->empty()) {
      return Fault{"the disparities" + of_scene + "are an empty interval"};
    }
    if (!(scene.weight >= 0) || !std::isfinite(scene.weight)) {
      return Fault{"the weight" + of_scene + "is no number of 0 or more"};
    }
    if (!(scene.scale > 0) || !std::isfinite(scene.scale)) {
      return Fault{"the scale" + of_scene + "is no number above 0"};
    }
    for (const DisparityFile* file : {&truth.disparity, &truth.reverse, &truth.visible}) {
      if (!std::isfinite(file->divisor)) {
        return Fault{"a divisor" + of_scene + "is no finite number"};
      }
    }
  }
  return std::nullopt;
}

MaybeFault Preprocess::fault_of(const ImagePair& result, const ImagePair& pair, const Context&) {
  if (result.is_reverse != pair.is_reverse) return Fault{"base and match image were exchanged"};
  return xgm::fault_of(result, pair.size());
}

MaybeFault Matcher::fault_of(const MatchResult& result, const MatchRequest& request,
                             const Context&) {
  const ImagePair& pair = request.pair;
  const Interval searched = request.range.hull();
  if (auto fault = fault_of_matched(result.forward, pair.base, searched)) return fault;
  if (!result.reverse) return std::nullopt;
  return fault_of_matched(
      *result.reverse, pair.match,
      request.reverse_range ? request.reverse_range->hull() : reversed(searched));
}

MaybeFault StereoFamily::fault_of(const MatchResult& result, const MatchRequest& request,
                                  const Context& context) {
  const cv::Size size = request.pair.size();
  if (auto fault = xgm::fault_of(result.forward, {size, context.searched()})) return fault;
  if (!result.reverse) return std::nullopt;
  return xgm::fault_of(*result.reverse, {size, context.other_view().searched()});
}

MaybeFault Cost::fault_of(const CostVolume& result, const ImagePair&, const VolumeShapePtr& shape,
                          const Context&) {
  if (result.shape_ptr() != shape) return Fault{"the volume does not have the shape given"};
  if (result.max_cost >= 0 && result.max_cost < CostVolume::kNoMatch) return std::nullopt;
  return Fault{"max_cost is not in 0 to 254"};
}

MaybeFault Aggregation::fault_of(const AggregatedVolume& result, const CostVolume& costs,
                                 const PenaltyField&, const Context&) {
  if (result.shape_ptr() != costs.shape_ptr()) {
    return Fault{"the sums do not have the costs' shape"};
  }
  if (result.fraction_bits >= 0 && result.fraction_bits < 16) return std::nullopt;
  return Fault{"fraction_bits is not in 0 to 15"};
}

MaybeFault Selection::fault_of(const DisparityMap& result, const AggregatedVolume& sums,
                               const Context&) {
  const VolumeShape& shape = sums.shape();
  if (auto fault = xgm::fault_of(result, {shape.size()})) return fault;
  return fault_if("a disparity is not a whole one of the pixel's range", result.size(), [&](int y) {
    return
        [slices = &shape.slice(y, 0), d = result.disparity[y], status = result.status[y]](int x) {
          const auto begin = static_cast<float>(slices[x].begin);
          const auto end = static_cast<float>(slices[x].begin + slices[x].count);
          const int outside = int{d[x] < begin} | int{d[x] >= end};
          return (int{has_disparity_at(status, x)} & (outside | int{!is_whole(d[x])})) != 0;
        };
  });
}

MaybeFault Refinement::fault_of(const DisparityMap& result, const DisparityMap& map,
                                const AggregatedVolume&, const Context&) {
  if (auto fault = xgm::fault_of(result, {map.size()})) return fault;
  const auto changed = fault_if("a status was changed", map.size(), [&](int y) {
    return [now = result.status[y], before = map.status[y]](int x) { return now[x] != before[x]; };
  });
  if (changed) return changed;
  return fault_if("a disparity was moved by more than half a pixel", map.size(), [&](int y) {
    // What has no disparity is NaN: no comparison is true of it.
    return [now = result.disparity[y], before = map.disparity[y]](int x) {
      return std::abs(now[x] - before[x]) > 0.5F;
    };
  });
}

MaybeFault Filter::fault_of(const DisparityMap& result, const DisparityMap& map, const ImagePair&,
                            const Context& context) {
  return xgm::fault_of(result, {map.size(), context.searched()});
}

MaybeFault Fuser::fault_of(const DisparityMap& result, const Candidates& candidates,
                           const ImagePair&, const Context&) {
  if (auto fault = xgm::fault_of(result, {candidates.maps.front().size()})) return fault;
  return fault_if("a disparity lies beyond the candidates'", result.size(), [&](int y) {
    return [&, y](int x) {
      const float d = result.disparity(y, x);
      const auto has = [&](const auto& compare) {  // no comparison is true of what is NaN
        return std::any_of(candidates.maps.begin(), candidates.maps.end(),
                           [&](const auto& map) { return compare(map.disparity(y, x), d); });
      };
      return result.has_disparity(y, x) &&
             !(has(std::less_equal<float>()) && has(std::greater_equal<float>()));
    };
  });
}

MaybeFault Consistency::fault_of(const MatchResult& result, const MatchResult& maps,
                                 const Context&) {
  if (auto fault = fault_of_kept(result.forward, maps.forward)) return fault;
  if (!result.reverse) return Fault{"the reverse map is gone"};
  return fault_of_kept(*result.reverse, *maps.reverse);
}

MaybeFault Confidence::fault_of(const cv::Mat1f& result, const Evidence& evidence, const Context&) {
  return fault_of_confidence(result, evidence.map.size());
}

MaybeFault SearchRange::fault_of(const DisparityRange& result, const DisparityMap&,
                                 const DisparityRange& limits, const Context&) {
  if (result.size() != limits.size()) {
    return Fault{"the range does not have the size of the limits"};
  }
  auto fault = fault_if("a pixel has nothing to search", limits.size(), [&](int y) {
    return [&, y](int x) { return !limits.at(y, x).empty() && result.at(y, x).empty(); };
  });
  if (!fault) return std::nullopt;
  const Interval interval = result.at(fault->pixel->y, fault->pixel->x);
  if (interval.end < interval.begin) fault->rule = "an interval ends before it begins";
  return fault;
}

}  // namespace xgm
