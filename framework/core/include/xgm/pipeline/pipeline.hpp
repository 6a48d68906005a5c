// SPDX-License-Identifier: Apache-2.0
// The facade: load and check a pipeline, run it. The command line and C++ programs use this.
#pragma once

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
#include "xgm/stage/context.hpp"
#include "xgm/stage/planner.hpp"

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
  /// Runs preprocess, matcher and postprocess. The result has the request's size. Throws Error, and
  /// Cancelled if the run is. Any number of runs, also of one pipeline, may be under way at once.
  MatchResult run(const MatchRequest& request, const RunOptions& options = {}) const;

  /// Walks through what run() does, and has every stage tell what it needs; see xgm/plan.hpp.
  void plan(const Workload& load, const Planner& planner) const;

  /// The disparities that the file itself asks for, if it does.
  std::optional<Interval> disparities() const;
  bool accepts_range_maps() const;

  /// Every parameter with the value it has, defaults included.
  std::string resolved_json() const;
  /// The stages and their parameters as an indented tree for reading.
  std::string graph() const;

 private:
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
/// Error with all diagnostics in its message.
XGM_API std::shared_ptr<const Stage> make_stage(std::string_view kind, const std::string& yaml,
                                                const Registry& registry);
template <class Kind>
std::shared_ptr<const Kind> make_stage(const std::string& yaml, const Registry& registry) {
  return std::dynamic_pointer_cast<const Kind>(make_stage(Kind::kKind, yaml, registry));
}

/// A plugin's parameters with types, units, ranges, defaults and texts.
XGM_API std::string describe_text(const PluginInfo& plugin);
XGM_API std::string describe_json(const PluginInfo& plugin);
XGM_API std::string describe_markdown(const PluginInfo& plugin);
/// JSON Schema (draft 7) of pipeline files, for editors.
XGM_API std::string pipeline_schema(const Registry& registry);

}  // namespace xgm
