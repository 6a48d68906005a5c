// SPDX-License-Identifier: Apache-2.0
// The rounds of a race, and what its clocks say.
#include <exception>

#include "speed/clocks.hpp"
#include "speed/opencv_peer.hpp"
#include "speed/stage_clock.hpp"
#include "xgm/base/aligned_buffer.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/simd.hpp"
#include "xgm/evaluation/speed.hpp"

namespace xgm {
namespace {

void add_run(SpeedTimes& times, const RunSeconds& seconds) {
  times.seconds.push_back(seconds.wall);
  times.cpu_seconds.push_back(seconds.cpu);
}

void add_stages(SpeedTimes& times, const speed::StageClock& clock, double seconds) {
  const std::size_t count = clock.totals().size();
  if (times.stages.empty()) {
    for (const auto& total : clock.totals()) times.stages.push_back({total.stage});
    times.stages.push_back({"(outside of stages)"});
  }
  double rest = seconds;
  for (std::size_t i = 0; i < count; ++i) {
    times.stages[i].seconds.push_back(clock.totals()[i].seconds);
    rest -= clock.totals()[i].seconds;
  }
  times.stages[count].seconds.push_back(rest);
}

void run_pipeline(SpeedTimes& times, const Pipeline& pipeline, const MatchRequest& request,
                  int threads) {
  speed::StageClock clock;
  const speed::Clocks clocks;
  const MatchResult result =
      pipeline.run(request, {.observer = &clock, .threads = threads, .simd = times.simd});
  const RunSeconds seconds = clocks.seconds();
  add_run(times, seconds);
  add_stages(times, clock, seconds.wall);
}

/// That a peer cannot do what is asked is worth a note, not the end of the race.
void run_peer(SpeedTimes& times, const std::string& mode, const speed::OpenCvPeer& peer) {
  if (!times.failure.empty()) return;
  try {
    add_run(times, peer.run(mode));
  } catch (const Error& error) {
    times.failure = error.message();
  } catch (const std::exception& error) {
    times.failure = error.what();
  }
}

}  // namespace

SpeedResult time_pipelines(const SpeedRace& race, const MatchRequest& request,
                           const std::function<void(const std::string&)>& tell) {
  if (!request.range.is_uniform()) {
    throw Error("times are compared for one interval of the whole image; give no range maps");
  }
  SpeedResult result{race, request.pair.size(), request.range.hull(), {}};
  std::vector<std::function<void(SpeedTimes&)>> runs;
  for (const SpeedPipeline& pipeline : race.pipelines) {
    for (const std::string& target : race.simd) {
      const SimdChoice known(target);  // throws before anything is timed
      result.times.push_back({pipeline.name, target});
      runs.emplace_back([&](SpeedTimes& times) {
        run_pipeline(times, pipeline.pipeline, request, race.threads);
      });
    }
  }
  const speed::OpenCvPeer peer(request.pair, request.range.hull());
  for (const std::string& mode : race.peers) {
    result.times.push_back({speed::peer_name(mode), ""});
    runs.emplace_back([&](SpeedTimes& times) { run_peer(times, mode, peer); });
  }
  const BufferReuse
      reuse;  // as where many pairs are matched: rounds do not begin by getting memory
  for (int round = 1; round <= race.rounds; ++round) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      tell("round " + std::to_string(round) + " of " + std::to_string(race.rounds) + ": " +
           result.times[i].name);
      runs[i](result.times[i]);
    }
  }
  return result;
}

}  // namespace xgm
