// SPDX-License-Identifier: Apache-2.0
// Finds good values of parameters by successive halving over a bench: many pipelines on few scenes,
// the better half of them on twice as many, until some are left on all (Jamieson and Talwalkar,
// Non-stochastic best arm identification and hyperparameter optimization, AISTATS 2016). Part of
// the scenes is held back, and says at the end what the choice is worth.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/evaluation/bench.hpp"

namespace xgm {

/// What a parameter may be: one of the values, or, if there are none, a number of a range.
struct TuneParameter {
  std::string path;
  std::vector<std::string> values{};  ///< YAML
  double low = 0, high = 0;           ///< both included
  bool whole = false;                 ///< whole numbers only
  bool logarithmic = false;           ///< each factor is as likely as any other
};

/// Parses "matcher.scale=4,8", "p1=4..40" or "p2=20..2000:log". A range is one of whole numbers if
/// both its ends are written so. Throws Error, also if two are of one path.
XGM_API std::vector<TuneParameter> parse_tune_parameters(const std::vector<std::string>& texts);

/// Whether the pipeline is sound with these values.
using IsSound = std::function<bool(const std::vector<Override>&)>;

/// The first value listed, or end of a range, with which no pipeline is sound, whatever the other
/// parameters are: it is a mistake, and rules between parameters are not what forbids it. Empty if
/// there is none.
XGM_API std::vector<Override> useless_value(const std::vector<TuneParameter>& parameters,
                                            const IsSound& is_sound, std::uint64_t seed);

/// At most `count` different points with which the pipeline is sound, chosen by the seed alone.
XGM_API std::vector<SweepPoint> draw_points(const std::vector<TuneParameter>& parameters,
                                            std::size_t count, const IsSound& is_sound,
                                            std::uint64_t seed);

/// So many pipelines on so many scenes.
struct Rung {
  std::size_t pipelines = 0, scenes = 0;
  friend bool operator==(const Rung&, const Rung&) = default;
};
/// From few scenes to all of them, twice as many each time, with half as many pipelines.
XGM_API std::vector<Rung> plan_rungs(std::size_t pipelines, std::size_t scenes);
/// The runs that this takes: none is made twice.
XGM_API std::size_t runs_of(const std::vector<Rung>& rungs);

/// How many pipelines the budget of runs allows, that of the beginning included, if two of them
/// are also run on the scenes held back. Throws UsageError if it does not allow two.
XGM_API std::size_t affordable_pipelines(std::size_t budget, std::size_t scenes,
                                         std::size_t held_out);

struct TuneRequest {
  BenchRequest bench{};  ///< its first pipeline is the one to better, the others are the candidates
  BenchRules rules{};    ///< pipelines are compared by the total error at the first threshold
  double held_out = 0.3;  ///< share of the scenes
  std::uint64_t seed = 0;
};

/// How many of the scenes are held back. At least one if the share is not 0, and never all.
XGM_API std::size_t held_out_count(double share, std::size_t scenes);

struct TunedPipeline {
  std::size_t pipeline = 0;  ///< of the request
  std::size_t scenes = 0;    ///< that it was compared on
  double error = 0;          ///< mean of them, 0 to 1; infinite if a run failed
  std::string failure{};     ///< of its first run that failed
};

struct XGM_API TuneResult {
  TuneRequest request;
  std::vector<std::size_t> tuning, held_out;  ///< scenes of the request
  std::vector<TunedPipeline> ranking;  ///< those that came furthest first, the best of them first
  std::size_t runs = 0;                ///< that were asked for, also those done before
  bool interrupted = false;
  /// On the scenes held back: of the first pipeline, and of the best. NaN without such scenes.
  double error_before = 0, error_after = 0;

  const TunedPipeline& best() const { return ranking.front(); }
  /// The pipeline to better, on the tuning scenes.
  const TunedPipeline& start() const;
};

/// Throws UsageError if a scene has no truth to judge by.
XGM_API TuneResult run_tune(const TuneRequest& request, const BenchHooks& hooks);

/// A table of all pipelines and what the scenes held back say, as Markdown or for terminals.
XGM_API std::string tune_markdown(const TuneResult& result);
XGM_API std::string tune_text(const TuneResult& result);
XGM_API std::string tune_json(const TuneResult& result);
/// The best pipeline with all its parameters, as a file to run.
XGM_API std::string best_yaml(const TuneResult& result);

}  // namespace xgm
