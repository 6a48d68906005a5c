// SPDX-License-Identifier: Apache-2.0
// All figures of the region judged, one line per average and per cell.
#include "bench/table.hpp"
#include "xgm/base/text.hpp"
#include "xgm/evaluation/bench_tables.hpp"

namespace xgm {
namespace {

class Lines {
 public:
  explicit Lines(const BenchResult& result) : result_(result) {
    out_ =
        "kind,set,scene,pipeline,state,scenes,weight,seconds,peak_bytes,mde_per_second,density,"
        "judged_pixels,average_error,rms,a50,a90,a95,a99,d1,invalid";
    for (const double delta : result.rules.thresholds) {
      out_ += ",bad_" + short_number(delta) + ",total_" + short_number(delta);
    }
    out_ += ",failure\n";
  }

  void add(const std::string& kind, const std::string& set, const std::string& scene,
           std::size_t pipeline, std::size_t scenes, double weight, const BenchCell& cell) {
    for (const std::string& text :
         {kind, set, scene, result_.request.pipelines[pipeline].name,
          std::string(state_text(cell.state)), std::to_string(scenes), csv_number(weight)}) {
      out_ += csv_field(text) + ",";
    }
    const bool done = cell.state == CellState::done;
    for (const double value :
         {cell.seconds, cell.peak_bytes, cell.evaluations / cell.seconds / 1e6, cell.density}) {
      out_ += (done ? csv_number(value) : "") + ",";
    }
    add_truth(cell);
    out_ += csv_field(cell.failure) + "\n";
  }

  std::string text() const { return out_; }

 private:
  void add_truth(const BenchCell& cell) {
    const Evaluation* e = judged(cell, result_.rules);
    if (e == nullptr) {
      out_ += std::string(9 + 2 * result_.rules.thresholds.size(), ',');
      return;
    }
    out_ += std::to_string(e->judged) + ",";
    for (const double value :
         {e->average_error, e->rms, e->a50, e->a90, e->a95, e->a99, e->d1, e->invalid}) {
      out_ += csv_number(value) + ",";
    }
    for (const ThresholdScore& score : e->at) {
      out_ += csv_number(score.bad) + "," + csv_number(score.total) + ",";
    }
  }

  const BenchResult& result_;
  std::string out_;
};

}  // namespace

std::string bench_csv(const BenchResult& result) {
  Lines lines(result);
  const auto& [request, rules, cells, interrupted] = result;
  for (const std::string& set : sets(result)) {
    for (std::size_t i = 0; i < request.pipelines.size(); ++i) {
      const BenchAverage mean = average(result, i, set);
      lines.add("average", set, "", i, mean.scenes, 1, mean.figures);
    }
  }
  for (std::size_t scene = 0; scene < request.scenes.size(); ++scene) {
    for (std::size_t i = 0; i < request.pipelines.size(); ++i) {
      const SceneFiles& files = request.scenes[scene].files;
      lines.add("scene", request.scenes[scene].set, files.name, i, 1, files.weight,
                result.at(i, scene));
    }
  }
  return lines.text();
}

}  // namespace xgm
