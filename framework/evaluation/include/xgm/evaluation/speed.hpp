// SPDX-License-Identifier: Apache-2.0
// Times pipelines, stage by stage, and OpenCV's StereoSGBM on the same images.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/match.hpp"
#include "xgm/pipeline/pipeline.hpp"

namespace xgm {

struct SpeedPipeline {
  std::string name;
  Pipeline pipeline;
};

/// What to time. Every contestant runs once in each round, so that a disturbance of the machine
/// affects all of them.
struct SpeedRace {
  std::vector<SpeedPipeline> pipelines;
  std::vector<std::string> simd;  ///< every pipeline runs with each of these; see xgm/base/simd.hpp
  std::vector<std::string> peers;  ///< of opencv_modes()
  /// Of the pipelines; at least 1. OpenCV has as many as the program has given it
  /// (cv::setNumThreads): the same ones, if times are to be compared.
  int threads = 1;
  int rounds = 5;  ///< at least 1
};

struct StageSeconds {
  std::string stage;              ///< "aggregation sgm": all calls of a run, views and levels
  std::vector<double> seconds{};  ///< per round, without nested stages
};

/// Of one run, from images in memory to the map.
struct RunSeconds {
  double wall = 0;
  double cpu = 0;  ///< of all threads; independent of other work of the machine
};

/// One contestant: a pipeline with one SIMD target, or one of OpenCV's modes.
struct SpeedTimes {
  std::string name;                    ///< "sgm8", "OpenCV HH"
  std::string simd;                    ///< empty for OpenCV, which chooses its own
  std::vector<double> seconds{};       ///< per round: wall time
  std::vector<double> cpu_seconds{};   ///< per round
  std::vector<StageSeconds> stages{};  ///< in the order in which they begin; OpenCV has none
  std::string failure{};               ///< why it could not be timed; empty if it could
};

struct SpeedResult {
  SpeedRace race;
  cv::Size size;
  Interval disparities;
  std::vector<SpeedTimes> times;  ///< the pipelines, then OpenCV
};

/// "hh", "hh4", "sgbm", "sgbm_3way": 8, 4, 5 and 3 path directions.
XGM_API const std::vector<std::string>& opencv_modes();

/// Runs and times all contestants. `request` has one interval for the whole image. OpenCV matches
/// only the left view, in 8-bit grey, converted beforehand, with blocks of 5 x 5, P1 = 8 * 25 and
/// P2 = 32 * 25, as its documentation recommends, and the same number of disparities, rounded up to
/// a multiple of 16; its left-right check cannot be switched off. The failure of a peer (memory,
/// disparities that it does not support) is recorded. Throws Error if a pipeline fails, or for an
/// unknown name. `tell` is called before each run ("round 2 of 5: sgm8").
XGM_API SpeedResult time_pipelines(const SpeedRace& race, const MatchRequest& request,
                                   const std::function<void(const std::string&)>& tell);

/// The median; of an even number of values, the mean of the middle two. 0 if there are none.
XGM_API double median(std::vector<double> values);

/// Tables by contestant and by stage, medians over the rounds; Markdown that is also readable as
/// text.
XGM_API std::string speed_markdown(const SpeedResult& result);
/// All results, every round.
XGM_API std::string speed_json(const SpeedResult& result);

}  // namespace xgm
