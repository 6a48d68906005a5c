// SPDX-License-Identifier: Apache-2.0
#include "xgm/pipeline/pipeline.hpp"

#include <algorithm>
#include <string>

#include "base/run_state.hpp"
#include "pipeline/family_meant.hpp"
#include "pipeline/graph.hpp"
#include "pipeline/named_parts.hpp"
#include "pipeline/overrides.hpp"
#include "plugin/binder.hpp"
#include "stage/misbehaviour.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/base/simd.hpp"
#include "xgm/stage/matcher.hpp"

namespace xgm {

struct Pipeline::Impl {
  std::string file;
  std::string family_name;
  std::shared_ptr<const Stage> family;
  Json resolved;
};

namespace {

void check_request(const MatchRequest& request) {
  require_sound(request.pair);
  if (request.range.size() != request.pair.size()) {
    throw UsageError("the search range is not of the images' size; make range maps of that size");
  }
  if (request.range.hull().empty()) {
    throw UsageError("the search range is empty; give at least one disparity");
  }
}

/// Stages call each other by slots, which look at results and exceptions; here nothing does.
MatchResult run_family(const StereoFamily& family, const std::string& name,
                       const MatchRequest& request, const Context& context) {
  const StagePlace place = place_of(PipelineFamily::kKind, name);
  try {
    MatchResult result = family.run(request, context);
    require_none(StereoFamily::fault_of(result, request, context), place);
    return result;
  } catch (...) {
    rethrow_as_error(place);
  }
}

/// A run that is given no token ends with the run that it is part of, if any.
RunState changed(RunState state, const RunOptions& options) {
  if (options.stop.stop_possible()) state.stop = options.stop;
  state.kept = options.kept;
  return state;
}

void as_run(const RunOptions& options, bool base_is_reverse,
            const std::function<void(const Context&)>& body) {
  const ThreadLimit limit(options.threads);
  const SimdChoice simd(options.simd);
  const RunChange run(changed(run_state(), options));
  const Context context =
      Context(options.observer, run.state.stop, base_is_reverse).with(options.facts);
  context.throw_if_cancelled();
  body(context);
}

}  // namespace

MatchResult Pipeline::run(const MatchRequest& request, const RunOptions& options) const {
  check_request(request);
  const StereoFamily* const stereo = stereo_family();
  if (stereo == nullptr) {
    throw UsageError("this pipeline matches no single image pair; see its 'type'");
  }
  if (!request.range.is_uniform() && !stereo->accepts_range_maps()) {
    throw UsageError("matcher: needs one range for the whole image; give no range maps");
  }
  MatchResult result;
  as_run(options, request.pair.is_reverse, [&](Context context) {
    context.take_view(request);
    result = run_family(*stereo, impl_->family_name, request, context);
  });
  return result;
}

void Pipeline::in_run(const RunOptions& options,
                      const std::function<void(const Context&)>& body) const {
  const StagePlace place = place_of(PipelineFamily::kKind, impl_->family_name);
  as_run(options, false, [&](const Context& context) {
    try {
      body(context);
    } catch (const UsageError&) {  // of the family itself, before any of its stages did work
      throw;
    } catch (...) {
      rethrow_as_error(place);
    }
  });
}

const Stage& Pipeline::family() const { return *impl_->family; }

const StereoFamily* Pipeline::stereo_family() const {
  return dynamic_cast<const StereoFamily*>(impl_->family.get());
}

std::optional<Interval> Pipeline::disparities() const {
  const StereoFamily* const stereo = stereo_family();
  return stereo != nullptr ? stereo->disparities() : std::nullopt;
}

bool Pipeline::accepts_range_maps() const {
  const StereoFamily* const stereo = stereo_family();
  return stereo != nullptr && stereo->accepts_range_maps();
}

const std::string& Pipeline::file() const { return impl_->file; }

std::string Pipeline::resolved_json() const { return impl_->resolved.dump(2); }

std::string Pipeline::graph() const { return graph_text(impl_->resolved); }

struct PipelineLoader {
  static LoadedPipeline load(Node root, const std::string& name, const Registry& registry,
                             const std::vector<Override>& overrides, Diagnostics diagnostics) {
    LoadedPipeline result;
    const bool sets_type = std::ranges::count(overrides, "type", &Override::path) > 0;
    if (root.is_map() && !sets_type) put_type_meant(root, registry, diagnostics);
    if (root.is_map()) read_named_parts(root, registry, diagnostics);
    for (const Override& change : overrides) {
      apply_override(root, change, diagnostics);
      if (root.is_map()) read_named_parts(root, registry, diagnostics);
    }
    if (!root.is_map()) {
      add_diagnostic(diagnostics, {name},
                     "a pipeline file is a map of stages, this is " + spell(root),
                     "start with 'xgm: 1' and 'matcher: {type: ...}'");
    } else {
      root.where = {name};
      auto bound = Binder(registry, diagnostics).pipeline(root);
      if (diagnostics.empty()) {
        Pipeline pipeline;
        pipeline.impl_ = std::make_shared<Pipeline::Impl>(
            Pipeline::Impl{name, bound.plugin, std::move(bound.stage), std::move(bound.resolved)});
        result.pipeline = std::move(pipeline);
      }
    }
    std::stable_sort(diagnostics.begin(), diagnostics.end(), [](const auto& a, const auto& b) {
      return std::pair(a.where.line, a.where.column) < std::pair(b.where.line, b.where.column);
    });
    // What is repeated by an alias has its faults once.
    const auto is_same = [](const auto& a, const auto& b) { return to_string(a) == to_string(b); };
    diagnostics.erase(std::unique(diagnostics.begin(), diagnostics.end(), is_same),
                      diagnostics.end());
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
  Diagnostics diagnostics;
  const auto text = read_pipeline_text(file, diagnostics);
  if (!text) return {std::nullopt, diagnostics};
  return load_pipeline_text(*text, file, registry, overrides);
}

std::shared_ptr<const Stage> make_stage(std::string_view kind, const std::string& yaml,
                                        const Registry& registry) {
  Diagnostics diagnostics;
  const std::optional<Node> node = read_yaml(yaml, std::string(kind), diagnostics);
  std::shared_ptr<const Stage> stage;
  if (node) stage = Binder(registry, diagnostics).stage(*node, kind).stage;
  if (stage != nullptr) return stage;
  throw UsageError(to_string(diagnostics));
}

}  // namespace xgm
