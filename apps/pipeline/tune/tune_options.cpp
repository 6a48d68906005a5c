// SPDX-License-Identifier: Apache-2.0
#include "tune/tune_options.hpp"

#include "options/values.hpp"
#include "xgm/base/error.hpp"

namespace xgm::cli {

BenchRules TuneOptions::rules() const {
  BenchRules rules = rules_of(bench);
  rules.thresholds = {threshold};
  return rules;
}

void TuneOptions::check() const {
  if (!(held_out >= 0 && held_out < 1)) {
    throw UsageError("--held-out: give a share from 0 to less than 1, for example 0.3");
  }
  if (!(threshold > 0)) throw UsageError("--threshold: give px above 0");
  if (budget < 1) throw UsageError("--budget: give a number of runs above 0");
  if (!bench.memory_limit.empty()) parse_bytes(bench.memory_limit, "--memory-limit");
}

void add_tune_options(Command command, TuneOptions& options) {
  command
      .option("pipeline", options.pipeline,
              "Pipeline file, or name of a shipped one: what is to be bettered")
      .type_name("PIPELINE")
      .required();
  add_bench_data(command, options.bench);
  command
      .option("--over", options.parameters,
              "A parameter and what it may be: values (matcher.scale=4,8), or a range of whole "
              "numbers (p1=4..40) or others (tau=0.5..20.0), with :log if factors matter "
              "(p2=20..2000:log); may be given again")
      .type_name("PATH=VALUES")
      .one_value_each()
      .required();
  command
      .option("--budget", options.budget,
              "Runs to spend, of one pipeline on one scene each, those on scenes held back "
              "included")
      .type_name("N")
      .required();
  command
      .option("--held-out", options.held_out,
              "Share of the scenes that take no part in the choice and judge it at the end")
      .type_name("SHARE")
      .show_default();
  command
      .option("--seed", options.seed,
              "Decides which scenes are held back and which values are tried")
      .type_name("N")
      .show_default();
  command
      .option("--threshold", options.threshold,
              "Pixels are wrong if they are by more than this, px after --scale")
      .type_name("PX")
      .show_default();
  add_bench_rules(command, options.bench);
  options.bench.output = "xgm_tune";
  command
      .option("-o,--output", options.bench.output,
              "Folder for tune.md, tune.json, best.yaml and, in PIPELINE/SET/SCENE, the results of "
              "every run. What is done there already is not run again")
      .type_name("DIR")
      .show_default();
  add_plugin_options(command, options.bench.plugins);
}

}  // namespace xgm::cli
