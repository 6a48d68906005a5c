// SPDX-License-Identifier: Apache-2.0
// A traced run, scaled: what each stage is going to be given and to take, and who holds what.
#include "xgm/pipeline/plan.hpp"

#include <algorithm>
#include <map>

#include "pipeline/ledger.hpp"
#include "pipeline/scaled_call.hpp"
#include "xgm/base/memory.hpp"

namespace xgm {
namespace {

using trace::Buffer;
using trace::Event;

// The heap that libraries begin with, code that is loaded when it is first called, stacks: with the
// files in memory, this is the peak of runs on 32 x 24 pixels.
constexpr double kProgramHeap = 14e6;
// Beside the true disparities: those of the other view, and masks.
constexpr double kTruthBytesPerPixel = 9;

/// Work that is done in the processor's caches is as fast as in the small run; what is not waits
/// for memory.
double seconds_of(const Needs& needs, double speed, double bandwidth) {
  const double waiting = bandwidth > 0 ? needs.moved / bandwidth : 0;
  return std::max(speed > 0 ? needs.updates / speed : 0, waiting);
}

/// Updates per second of each plugin in the small run, by kind and name.
std::map<std::string, double> speeds(const RunTrace& trace) {
  std::map<std::string, double> updates, seconds, speeds;
  const trace::Scale small(trace, trace.calls().load);
  for (const trace::Call& call : trace.calls().calls) {
    const std::string key = call.place.kind + "/" + call.place.plugin;
    updates[key] += small.needs(call, small.load(call)).updates;
    seconds[key] += call.seconds;
  }
  for (const auto& [key, time] : seconds) speeds[key] = updates[key] / std::max(time, 1e-9);
  return speeds;
}

/// Walks through the events of the small run with the sizes of the large one.
class Walk {
 public:
  Walk(const RunTrace& trace, const PlanRequest& request, PlanLedger& ledger)
      : calls_(trace.calls()),
        scale_(trace, request.load),
        besides_(request.besides),
        ledger_(ledger) {
    held_.resize(calls_.buffers.size());
    last_take_.resize(calls_.buffers.size(), -1);
    for (const Event& event : calls_.events) {
      if (event.what == Event::What::take) last_take_[at(event.buffer)] = event.call;
    }
  }

  void run() {
    for (const Event& event : calls_.events) {
      switch (event.what) {
        case Event::What::begin:
          begin(event.call);
          break;
        case Event::What::take:
        case Event::What::give:
          hold(event.buffer, call(event.call).parent, call(event.call));
          break;
        case Event::What::end:
          end(event.call);
          break;
      }
    }
    ledger_.give_back_volumes();
    ledger_.add(besides_.after, 0);
  }

 private:
  /// A buffer that lives in the plan.
  struct Held {
    bool now = false;
    int holder = -1;  ///< the call that holds it; -1: the pipeline
    double heap = 0, volumes = 0;
  };

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  const trace::Call& call(int i) const { return calls_.calls[at(i)]; }

  void begin(int i) {
    const trace::Call& seen = call(i);
    PlannedStage stage;
    stage.place = seen.place;
    stage.load = scale_.load(seen);
    stage.needs = scale_.needs(seen, stage.load);
    if (seen.same_as >= 0) stage.same_as = call(seen.same_as).place.path;
    ledger_.stages.push_back(std::move(stage));
    ledger_.begin(at(i));
    const bool is_last = seen.same_as >= 0 && call(seen.same_as).kept_until == i;
    if (is_last) ledger_.add(-scale_.kept_bytes(call(seen.same_as)), 0);
  }

  void hold(int buffer, int holder, const trace::Call& by) {
    Held& held = held_[at(buffer)];
    if (held.now) {
      held.holder = std::min(held.holder, holder);  // handed on to a call further out
      return;
    }
    const Buffer& seen = calls_.buffers[at(buffer)];
    const bool is_volume = seen.kind == Buffer::Kind::volume;
    const double bytes =
        is_volume ? scale_.volume_bytes(seen, call(seen.call)) : scale_.pixel_bytes(seen, by);
    held = {true, holder, is_volume ? 0 : bytes, is_volume ? bytes : 0};
    ledger_.add(held.heap, held.volumes);
  }

  void end(int i) {
    const Needs& needs = ledger_.stages[at(i)].needs;
    ledger_.add(needs.working, 0);
    ledger_.add(-needs.working, 0);
    ledger_.end();
    for (std::size_t b = 0; b < held_.size(); ++b) {
      const bool passing = calls_.buffers[b].kind != Buffer::Kind::pixels && last_take_[b] == i;
      if (held_[b].now && (held_[b].holder == i || passing)) release(held_[b]);
    }
    if (call(i).kept_until >= 0) ledger_.add(scale_.kept_bytes(call(i)), 0);
    if (is_level(call(i)))
      ledger_.add(besides_.level_pixel * ledger_.stages[at(i)].load.pixels(), 0);
    if (call(i).parent >= 0) return;
    // As Pipeline::run() does: key points leave hundreds of MB behind, volumes wait for the next.
    if (call(i).is_matcher) {
      if (!besides_.volumes_stay) ledger_.give_back_volumes();
    } else if (call(i).place.kind == "preprocess") {
      ledger_.give_back_heap();
    }
  }

  /// Whether it is the matcher of a level's base view, which a level has one of.
  bool is_level(const trace::Call& seen) const {
    const StagePlace& place = seen.place;
    if (!seen.is_matcher || place.level.name.empty() || place.view != View::forward) return false;
    return seen.parent < 0 || call(seen.parent).place.level.path != place.level.path;
  }

  void release(Held& held) {
    held.now = false;
    ledger_.add(-held.heap, -held.volumes);
  }

  const RunTrace::Calls& calls_;
  trace::Scale scale_;
  Besides besides_;
  PlanLedger& ledger_;
  std::vector<Held> held_;
  std::vector<int> last_take_;  ///< of each buffer, the call that was given it last
};

}  // namespace

Workload workload_of(const MatchRequest& request, int threads) {
  const Image& base = request.pair.base;
  return workload_of(request.range, static_cast<int>(base.planes.size()), base.valid, threads);
}

Workload workload_of(const DisparityRange& range, int planes, const cv::Mat1b& valid, int threads) {
  Workload load = Workload::dense(range.size(), planes, range.hull());
  load.threads = threads;
  load.masked = !valid.empty();
  if (load.masked) load.used = cv::countNonZero(valid) / load.pixels();
  load.ragged = !range.is_uniform();
  if (load.ragged) load.cells_per_pixel = trace::mean_searched(range, valid).cells;
  return load;
}

double usual_bytes(const Workload& load) {
  constexpr double kCostsAndSums = 3, kSmaller = 1.4;  // levels of a pyramid, lines of path costs
  constexpr double kKeyPoints = 1.5e9, kBytesPerPixel = 100;
  return kSmaller * kCostsAndSums * load.cells() + kBytesPerPixel * load.pixels() + kKeyPoints;
}

RunPlan plan_run(const RunTrace& trace, const PlanRequest& request) {
  const Workload& load = request.load;
  PlanLedger ledger(static_cast<double>(program_memory()) + kProgramHeap + request.besides.held +
                    (request.truth ? kTruthBytesPerPixel * load.pixels() : 0));
  Walk(trace, request, ledger).run();

  RunPlan plan;
  plan.narrowing = trace.narrowing;
  plan.peak_bytes = ledger.peak_bytes;
  plan.peak_stage = ledger.stages[ledger.peak_stage].place.path;
  plan.stages = std::move(ledger.stages);
  const auto speed = speeds(trace);
  for (PlannedStage& stage : plan.stages) {
    stage.seconds = seconds_of(stage.needs, speed.at(stage.place.kind + "/" + stage.place.plugin),
                               trace.calls().bandwidth);
    plan.seconds += stage.seconds;
    plan.estimated = plan.estimated || stage.load.estimated;
  }
  return plan;
}

int max_disparities(const RunTrace& trace, PlanRequest request, double bytes) {
  const Interval asked = request.load.range;
  const auto fits = [&](int count) {
    request.load.range.end = asked.begin + count;
    request.load.cells_per_pixel = Workload::room(count);
    return plan_run(trace, request).peak_bytes <= bytes;
  };
  int good = 0, bad = asked.size() + 1;
  while (bad - good > 1) {
    const int middle = good + (bad - good) / 2;
    (fits(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace xgm
