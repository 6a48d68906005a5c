// SPDX-License-Identifier: Apache-2.0
// Load and check a pipeline, run it on a pair of images.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "xgm/base/error.hpp"
#include "xgm/base/export.hpp"
#include "xgm/config/diagnostics.hpp"
#include "xgm/data/match.hpp"
#include "xgm/pipeline/run_options.hpp"
#include "xgm/plugin/registry.hpp"
#include "xgm/stage/pipeline.hpp"

namespace xgm {

/// A value given from outside the file: `path` ("matcher.scale", "postprocess[0].radius") and YAML
/// text. Replaces or adds what stands there.
struct Override {
  std::string path;
  std::string value;
};

/// A checked pipeline, ready to run any number of times.
class XGM_API Pipeline {
 public:
  /// Runs preprocess, matcher and postprocess. The result has the request's size. Throws UsageError
  /// for a request that fits neither itself nor the pipeline, Cancelled if the run is, and Error.
  /// Any number of runs, also of one pipeline, may be under way at once.
  MatchResult run(const MatchRequest& request, const RunOptions& options = {}) const;

  /// Calls `body`, as a run with these options, with the outermost context of a family that is not
  /// a StereoFamily. Throws what it throws, and Cancelled.
  void in_run(const RunOptions& options, const std::function<void(const Context&)>& body) const;

  /// What the file is: a StereoFamily, or that of another room or plugin file.
  const Stage& family() const;

  /// The disparities that the file itself asks for, if it does.
  std::optional<Interval> disparities() const;
  bool accepts_range_maps() const;

  /// The file that it was loaded from, or the name that was given to its text.
  const std::string& file() const;
  /// Every parameter with the value it has, defaults included.
  std::string resolved_json() const;
  /// The stages and their parameters as an indented tree for reading.
  std::string graph() const;

 private:
  const StereoFamily* stereo_family() const;

  friend struct PipelineLoader;
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

/// Either a pipeline or all that is wrong with the file, sorted by place.
struct LoadedPipeline {
  std::optional<Pipeline> pipeline;
  Diagnostics diagnostics;
};

/// Reads and checks a pipeline file. Never throws for the user's mistakes; opens no image.
XGM_API LoadedPipeline load_pipeline(const std::string& file, const Registry& registry,
                                     const std::vector<Override>& overrides = {});
/// The same for text; `name` stands for the file in messages.
XGM_API LoadedPipeline load_pipeline_text(const std::string& text, const std::string& name,
                                          const Registry& registry,
                                          const std::vector<Override>& overrides = {});

/// Makes one stage from YAML: make_stage("cost", "{type: census, window: 7}", registry). Throws
/// UsageError with all diagnostics in its message.
XGM_API std::shared_ptr<const Stage> make_stage(std::string_view kind, const std::string& yaml,
                                                const Registry& registry);
template <class Kind>
std::shared_ptr<const Kind> make_stage(const std::string& yaml, const Registry& registry) {
  return std::dynamic_pointer_cast<const Kind>(make_stage(Kind::kKind, yaml, registry));
}

}  // namespace xgm
