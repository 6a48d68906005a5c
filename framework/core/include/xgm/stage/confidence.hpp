// SPDX-License-Identifier: Apache-2.0
// Kind "confidence": how sure is each disparity?
#pragma once

#include "xgm/data/volume.hpp"
#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

/// What a confidence stage may look at. What a stage needs and does not find is a mistake in the
/// pipeline, which the matcher that holds the stage refuses.
struct Evidence {
  const ImagePair& pair;                   ///< `pair.base` is the view of the map
  const DisparityMap& map;                 ///< with the confidence that it has so far, if any
  const AggregatedVolume* sums = nullptr;  ///< that the map was selected from; in semi_global
  const DisparityMap* other = nullptr;     ///< the map of the other view; in left_right

  /// All that there is, for those who watch what stages are given.
  template <class Visit>
  void each(const Visit& visit) const {
    visit(pair);
    visit(map);
    if (sums != nullptr) visit(*sums);
    if (other != nullptr) visit(*other);
  }
};

class XGM_API Confidence : public Stage {
 public:
  static constexpr std::string_view kKind = "confidence";
  static constexpr std::string_view kMeaning = "says how sure each disparity is";

  /// 0 (not at all) to 1 per pixel; NaN where nothing can be told, and where the map has no
  /// disparity.
  virtual cv::Mat1f run(const Evidence& evidence, const Context& context) const = 0;

  virtual bool needs_sums() const { return false; }
  virtual bool needs_other_view() const { return false; }
  /// Whether the map must have a confidence already.
  virtual bool needs_confidence() const { return false; }

  /// What every result is looked at for in a run: size and bounds.
  static std::optional<Fault> fault_of(const cv::Mat1f& result, const Evidence& evidence,
                                       const Context& context);
};

}  // namespace xgm
