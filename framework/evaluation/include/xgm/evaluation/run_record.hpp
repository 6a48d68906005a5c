// SPDX-License-Identifier: Apache-2.0
// What happened in a run, and its record as JSON (run.json).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/evaluation/metrics.hpp"
#include "xgm/io/dump.hpp"
#include "xgm/io/scene.hpp"
#include "xgm/pipeline/pipeline.hpp"

namespace xgm {

/// One call of one stage, in the order in which they began.
struct StageRecord {
  StagePlace place;  ///< without the stage itself, which may be gone
  StageStatistics statistics;
  bool finished = false;
  std::vector<std::pair<std::string, double>> figures;  ///< that the stage told
  std::string same_as{};  ///< path of the stage whose result it was given; empty if it ran itself
};

/// Collects the stages of a run.
class XGM_API RunRecorder final : public Observer {
 public:
  void stage_begin(const StagePlace& place) override;
  void stage_end(const StagePlace& place, const StageStatistics& statistics,
                 const Artifact& result) override;
  void stage_same_as(const StagePlace& place, const std::string& earlier) override;
  void figure(const StagePlace& place, const std::string& name, double value) override;

  const std::vector<StageRecord>& stages() const { return stages_; }

 private:
  std::vector<StageRecord> stages_;
};

/// A file that a run wrote into its folder.
struct OutputFile {
  std::string file;                      ///< relative to the folder
  std::optional<std::uint64_t> bytes{};  ///< none: the run has not ended
};

/// All that run.json holds.
struct RunRecord {
  std::string pipeline_file;
  std::string resolved_pipeline;  ///< Pipeline::resolved_json()
  std::vector<Override> overrides;
  std::vector<std::string> command_line;

  std::string scene;
  std::vector<InputFile> inputs;
  cv::Size size;
  Interval disparities;          ///< hull of what was searched
  std::string disparities_from;  ///< "command line", "calibration", "pipeline", ...
  int threads = 0;

  std::vector<StageRecord> stages;
  std::vector<std::string>
      reused;               ///< results of earlier runs, which no stage has made in this one
  std::string reused_from;  ///< folder
  std::vector<std::string> warnings;
  std::vector<DumpedFile> dumps;
  std::vector<OutputFile> outputs;  ///< beside run.json itself
  double reading_seconds = 0;
  double matching_seconds = 0;
  std::uint64_t peak_memory_bytes = 0;

  double valid_share = 0;
  std::array<double, kStatusCount> status_shares{};
  std::vector<RegionEvaluation> truth;  ///< empty if nothing is known
};

/// The record as indented JSON, versions of xgm, OpenCV and the compiler included.
XGM_API std::string to_json(const RunRecord& record);

/// The files that were read, from the text of a run.json; empty if it is none.
XGM_API std::vector<InputFile> recorded_inputs(const std::string& run_json);
/// The files that were written, likewise. Names that lead out of the folder are left out.
XGM_API std::vector<OutputFile> recorded_outputs(const std::string& run_json);

}  // namespace xgm
