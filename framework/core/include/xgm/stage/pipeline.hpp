// SPDX-License-Identifier: Apache-2.0
// Kind "pipeline": what a pipeline file holds at its top, and what is made of it. A file names its
// family with `type`; without it, it is a stereo pipeline.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "xgm/data/pair_windows.hpp"
#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

/// The parameters of the plugin are the top of the file. Each family has a base class with a run()
/// of its own, which programs reach by Pipeline::family().
class XGM_API PipelineFamily : public Stage {
 public:
  static constexpr std::string_view kKind = "pipeline";
  static constexpr std::string_view kMeaning = "is what a pipeline file holds at its top";
  /// The family of files that do not say theirs.
  static constexpr std::string_view kDefault = "stereo";
};

/// From one image pair to its disparity maps.
class XGM_API StereoFamily : public PipelineFamily {
 public:
  /// Maps of the request's size.
  virtual MatchResult run(const MatchRequest& request, const Context& context) const = 0;

  /// What every result is looked at for: both maps, their size and the range that was asked for.
  static std::optional<Fault> fault_of(const MatchResult& result, const MatchRequest& request,
                                       const Context& context);

  /// The disparities that the file itself asks for, if it does.
  virtual std::optional<Interval> disparities() const = 0;
  virtual bool accepts_range_maps() const = 0;
  /// Whether its maps have a confidence.
  virtual bool gives_confidence() const { return false; }

  /// For scenes that are matched in parts (ScenePart): how many times smaller than the images the
  /// coarsest level is, and the scene as it is after what is done before matching.
  virtual int coarsest_scale() const { return 1; }
  virtual std::shared_ptr<const PairWindows> prepared(std::shared_ptr<const PairWindows> scene,
                                                      const Context& context) const;

  /// For parts that are matched by many processes: whether prepared() may look at the whole scene,
  /// what it finds there, as JSON, and what it returns, to the last bit, once that is known.
  virtual bool looks_at_whole() const { return false; }
  virtual std::string found_on_whole(std::shared_ptr<const PairWindows> scene,
                                     const Context& context) const;
  virtual std::shared_ptr<const PairWindows> prepared_with(const std::string& found,
                                                           std::shared_ptr<const PairWindows> scene,
                                                           const Context& context) const;
};

}  // namespace xgm
