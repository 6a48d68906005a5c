// SPDX-License-Identifier: Apache-2.0
#include "xgm/pipeline/pipeline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>

#include "base/run_state.hpp"
#include "pipeline/graph.hpp"
#include "pipeline/overrides.hpp"
#include "plugin/binder.hpp"
#include "xgm/base/aligned_buffer.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/simd.hpp"
#include "xgm/plugin.hpp"

namespace xgm {
namespace {

// The top of a pipeline file is declared like any stage's parameters.
struct PipelineParameters {
  int version = 1;
  std::vector<double> disparities;
  SlotList<Preprocess> preprocess;
  Slot<Matcher> matcher;
  SlotList<Filter> postprocess;
};

}  // namespace

// Widest bound of disparities that a file may ask for; keeps sums of bounds within an int.
static constexpr double kMaxDisparity = 1e6;

static void describe(PipelineParameters& p, ParameterSet& set) {
  set.add("xgm", p.version, "Version of the file format.").range(1, 1);
  set.add("disparities", p.disparities,
          "Search range [first, last], both included, when neither the command line nor the scene "
          "gives one.")
      .unit("px")
      .range(-kMaxDisparity, kMaxDisparity);
  set.add("preprocess", p.preprocess, "What is done to the images before matching, in order.");
  set.add("matcher", p.matcher, "Finds the disparity map.");
  set.add("postprocess", p.postprocess, "What is done to the finished maps, in order.");
  set.rule({"disparities"}, "must be two whole numbers, the first not above the second", [&p] {
    const auto& d = p.disparities;
    const auto whole = [](double v) { return v == std::floor(v); };
    return d.empty() || (d.size() == 2 && whole(d[0]) && whole(d[1]) && d[0] <= d[1]);
  });
}

ParameterSet pipeline_parameters() {
  static PipelineParameters defaults;
  ParameterSet set;
  describe(defaults, set);
  return set;
}

struct Pipeline::Impl {
  PipelineParameters parameters;
  nlohmann::ordered_json resolved;
};

namespace {

void check_request(const MatchRequest& request) {
  const cv::Size size = request.pair.size();
  if (size.empty()) throw Error("the images are empty; give an image pair with pixels");
  if (request.pair.match.size() != size) {
    throw Error("the images differ in size; a rectified pair has images of one size");
  }
  if (request.range.size() != size) {
    throw Error("the search range is not of the images' size; make range maps of that size");
  }
  if (request.range.hull().empty()) {
    throw Error("the search range is empty; give at least one disparity");
  }
}

/// A run that is given no token ends with the run that it is part of, if any.
RunState with_stop(RunState state, const std::stop_token& stop) {
  if (stop.stop_possible()) state.stop = stop;
  return state;
}

/// Key points leave hundreds of MB in the heap, also if the run is cancelled meanwhile.
struct HeapTrimmed {
  ~HeapTrimmed() { trim_heap(); }
};

ImagePair preprocess(const Context& context, const SlotList<Preprocess>& stages, ImagePair pair) {
  if (stages.empty()) return pair;
  const HeapTrimmed trimmed;
  for (const auto& stage : stages) pair = stage(context, pair);
  return pair;
}

/// What volumes leave for each other is gone before the maps are worked on.
MatchResult match(const Context& context, const Slot<Matcher>& matcher,
                  const MatchRequest& request) {
  const BufferReuse reuse;
  return matcher(context, request);
}

}  // namespace

MatchResult Pipeline::run(const MatchRequest& request, const RunOptions& options) const {
  check_request(request);
  const PipelineParameters& p = impl_->parameters;
  if (!request.range.is_uniform() && !accepts_range_maps()) {
    throw Error("matcher", "needs one range for the whole image; give no range maps");
  }
  const ThreadLimit limit(options.threads);
  const SimdChoice simd(options.simd);
  const RunChange run(with_stop(run_state(), options.stop));
  const Context context(options.observer, run.state.stop);
  context.throw_if_cancelled();
  MatchRequest prepared = request;
  prepared.pair = preprocess(context.part(0, 0.03), p.preprocess, request.pair);
  MatchResult result = match(context.part(0.03, 0.95), p.matcher, prepared);
  for (const auto& stage : p.postprocess) {
    const Context rest = context.part(0.95, 1);
    result.forward = stage(rest, result.forward, prepared.pair);
    if (result.reverse) {
      result.reverse = stage(rest.scope("reverse"), *result.reverse, prepared.pair.swapped());
    }
  }
  return result;
}

void Pipeline::plan(const Workload& load, const Planner& planner) const {
  const PipelineParameters& p = impl_->parameters;
  Planner::Hold pair;  // run() begins with the caller's, which the caller holds
  for (const auto& stage : p.preprocess) pair = stage.plan(planner, load);
  planner.drop_free_heap();
  Planner::Hold forward = p.matcher.plan(planner, load);
  planner.drop_free_volumes();
  for (const auto& stage : p.postprocess) {
    forward = stage.plan(planner, load);
    if (p.matcher->gives_reverse_map()) {
      const Planner::Hold reverse = stage.plan(planner.scope("reverse"), load);
    }
  }
}

std::optional<Interval> Pipeline::disparities() const {
  const auto& d = impl_->parameters.disparities;
  if (d.empty()) return std::nullopt;
  return Interval{static_cast<int>(d[0]), static_cast<int>(d[1]) + 1};
}

bool Pipeline::accepts_range_maps() const {
  return impl_->parameters.matcher->accepts_range_maps();
}

std::string Pipeline::resolved_json() const { return impl_->resolved.dump(2); }

std::string Pipeline::graph() const { return graph_text(impl_->resolved); }

struct PipelineLoader {
  static LoadedPipeline load(Node root, const std::string& name, const Registry& registry,
                             const std::vector<Override>& overrides, Diagnostics diagnostics) {
    LoadedPipeline result;
    for (const Override& change : overrides) apply_override(root, change, diagnostics);
    if (!root.is_map()) {
      report(diagnostics, {name}, "a pipeline file is a map of stages, this is " + spell(root),
             "start with 'xgm: 1' and 'matcher: {type: ...}'");
    } else {
      const auto impl = std::make_shared<Pipeline::Impl>();
      ParameterSet set;
      describe(impl->parameters, set);
      root.where = {name};
      impl->resolved = Binder(registry, diagnostics).fields(root, set, "a pipeline").resolved;
      Pipeline pipeline;
      pipeline.impl_ = impl;
      if (diagnostics.empty()) result.pipeline = std::move(pipeline);
    }
    std::stable_sort(diagnostics.begin(), diagnostics.end(), [](const auto& a, const auto& b) {
      return std::pair(a.where.line, a.where.column) < std::pair(b.where.line, b.where.column);
    });
    result.diagnostics = std::move(diagnostics);
    return result;
  }
};

LoadedPipeline load_pipeline_text(const std::string& text, const std::string& name,
                                  const Registry& registry,
                                  const std::vector<Override>& overrides) {
  Diagnostics diagnostics;
  std::optional<Node> root = read_yaml(text, name, diagnostics);
  if (!root) return {std::nullopt, diagnostics};
  return PipelineLoader::load(std::move(*root), name, registry, overrides, {});
}

LoadedPipeline load_pipeline(const std::string& file, const Registry& registry,
                             const std::vector<Override>& overrides) {
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  std::array<char, 1 << 16> piece;
  while (stream && text.size() <= kMaxYamlBytes) {  // what is named by mistake may have no end
    stream.read(piece.data(), piece.size());
    text.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.is_open() || stream.bad()) {
    LoadedPipeline unread;
    report(unread.diagnostics, {file}, "cannot be read", "check the path and the permissions");
    return unread;
  }
  return load_pipeline_text(text, file, registry, overrides);
}

std::shared_ptr<const Stage> make_stage(std::string_view kind, const std::string& yaml,
                                        const Registry& registry) {
  Diagnostics diagnostics;
  const std::optional<Node> node = read_yaml(yaml, std::string(kind), diagnostics);
  std::shared_ptr<const Stage> stage;
  if (node) stage = Binder(registry, diagnostics).stage(*node, kind).stage;
  if (stage != nullptr) return stage;
  std::string message;
  for (const Diagnostic& d : diagnostics) message += (message.empty() ? "" : "\n") + to_string(d);
  throw Error(message);
}

}  // namespace xgm
