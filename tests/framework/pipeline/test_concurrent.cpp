// SPDX-License-Identifier: Apache-2.0
// Runs in one process do not know of each other, and any of them can be ended.
#include <chrono>
#include <future>
#include <stop_token>
#include <thread>

#include "support/paths.hpp"
#include "support/support.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/simd.hpp"
#include "xgm/testing/synthetic.hpp"

using namespace xgm;
using Clock = std::chrono::steady_clock;

namespace {

// Sanitizers take ten times as long.
#ifdef XGM_SANITIZED
constexpr std::chrono::seconds kSoon(10);
#else
constexpr std::chrono::seconds kSoon(1);
#endif

/// A pipeline with a pair of its own, and the maps that it gives when nothing else runs.
struct Job {
  Pipeline pipeline;
  MatchRequest request;
  RunOptions options;
  MatchResult alone;

  MatchResult run(std::stop_token stop = {}, Observer* observer = nullptr) const {
    RunOptions with = options;
    with.stop = std::move(stop);
    with.observer = observer;
    return pipeline.run(request, with);
  }
  bool right(const MatchResult& result) const {
    if (result.reverse.has_value() != alone.reverse.has_value()) return false;
    return xgm::testing::identical(result.forward, alone.forward) &&
           (!result.reverse || xgm::testing::identical(*result.reverse, *alone.reverse));
  }
};

Job make_job(const std::string& name, cv::Size size, Interval disparities, std::uint64_t seed,
             const RunOptions& options) {
  const LoadedPipeline loaded =
      load_pipeline(XGM_SOURCE_DIR "/pipelines/" + name + ".yaml", xgm::testing::builtins());
  REQUIRE(loaded.pipeline.has_value());
  xgm::testing::SceneOptions scene;
  scene.size = size;
  scene.disparities = disparities;
  scene.seed = seed;
  MatchRequest request{
      xgm::testing::make_scene(scene).pair, DisparityRange::uniform(size, disparities), {}};
  MatchResult alone = loaded.pipeline->run(request);
  return {*loaded.pipeline, std::move(request), options, std::move(alone)};
}

/// Coarse to fine, on two threads, without vectors.
const Job& fine_job() {
  static const Job job =
      make_job("tmgm8", {150, 100}, {-5, 30}, 1, {.threads = 2, .simd = "scalar"});
  return job;
}

/// On three threads, with the best vectors, and with sums that are large enough for the pool.
const Job& large_job() {
  static const Job job = make_job("sgm8", {256, 192}, {0, 96}, 2, {.threads = 3});
  return job;
}

/// Ends the run from within: when its n-th stage begins or ends, or when it has come so far.
struct Ending : Observer {
  explicit Ending(int event, double done = 2) : left(event), share(done) {}
  void stage_begin(const StagePlace&) override { count(--left == 0); }
  void stage_end(const StagePlace&, const StageStatistics&, const Artifact&) override {
    count(--left == 0);
  }
  void progress(double done) override { count(done >= share); }
  void count(bool last) {
    late += stop.stop_requested();
    if (last) stop.request_stop();
  }
  int left;
  double share;
  int late = 0;  ///< calls after the end
  std::stop_source stop;
};

/// Says when a stage begins.
struct Gate : Observer {
  explicit Gate(std::string wanted) : plugin(std::move(wanted)) {}
  void stage_begin(const StagePlace& place) override {
    if (place.plugin != plugin || passed) return;
    passed = true;
    there.set_value();
  }
  std::string plugin;
  bool passed = false;
  std::promise<void> there;
};

}  // namespace

TEST_CASE("two runs at once give the bytes that each gives alone") {
  fine_job();
  large_job();
  int wrong_fine = 0, wrong_large = 0;
  std::thread fine([&] {
    for (int round = 0; round < 3; ++round) wrong_fine += !fine_job().right(fine_job().run());
  });
  std::thread large([&] {
    for (int round = 0; round < 3; ++round) wrong_large += !large_job().right(large_job().run());
  });
  fine.join();
  large.join();
  CHECK(wrong_fine == 0);
  CHECK(wrong_large == 0);
}

TEST_CASE("a run leaves threads and SIMD target of its caller as they were") {
  const int threads = thread_count();
  fine_job().run();
  CHECK(thread_count() == threads);
  CHECK(simd_target() == simd_targets().front());
  CHECK_THROWS_WITH_AS(large_job().pipeline.run(large_job().request, {.simd = "avx1024"}),
                       doctest::Contains("no SIMD target 'avx1024'"), Error);
}

TEST_CASE("a run that is cancelled before it begins does nothing") {
  std::stop_source stop;
  stop.request_stop();
  Ending observer(1);
  CHECK_THROWS_AS(fine_job().run(stop.get_token(), &observer), Cancelled);
  CHECK(observer.left == 1);
}

TEST_CASE("a run can be cancelled wherever it is, and tells nothing more") {
  const Job& job = fine_job();
  const auto check = [&](Ending ending) {
    CHECK_THROWS_WITH_AS(job.run(ending.stop.get_token(), &ending), "the run was cancelled",
                         Cancelled);
    CHECK(ending.late == 0);
  };
  Ending all(0);
  job.run({}, &all);
  const int events = -all.left;
  REQUIRE(events > 50);
  for (int event = 1; event < events; event += 1 + events / 10) {
    CAPTURE(event);
    check(Ending(event));
  }
  for (const double share : {0.03, 0.4, 0.9}) {
    CAPTURE(share);
    check(Ending(0, share));
  }
  CHECK(job.right(job.run()));
}

TEST_CASE("a run that another thread cancels ends within a second, and the next one is right") {
  const Job& job = large_job();
  for (const std::string plugin : {"census", "sgm", "wta", "median"}) {
    CAPTURE(plugin);
    std::stop_source stop;
    Gate gate(plugin);
    auto run = std::async(std::launch::async, [&] {
      CHECK_THROWS_AS(job.run(stop.get_token(), &gate), Cancelled);
      return Clock::now();
    });
    gate.there.get_future().wait();
    const auto cancelled = Clock::now();
    stop.request_stop();
    CHECK(run.get() - cancelled < kSoon);
  }
  CHECK(job.right(job.run()));
}

TEST_CASE("runs that are cancelled do not disturb one that is not, and leave no memory behind") {
  const Job& job = large_job();
  fine_job();
  bool right = false;
  const std::uint64_t before = resident_memory();
  std::thread other([&] { right = fine_job().right(fine_job().run()); });
  for (const int event : {8, 20, 3, 12}) {
    Ending observer(event);
    CHECK_THROWS_AS(job.run(observer.stop.get_token(), &observer), Cancelled);
  }
  other.join();
  CHECK(right);
  CHECK(job.right(job.run()));
#ifndef XGM_SANITIZED
  trim_heap();  // what the threads' arenas keep for later is no leak
  CHECK(resident_memory() < before + (std::uint64_t{8} << 20));
#else
  static_cast<void>(before);
#endif
}

namespace {

/// Has a long loop of its own.
class PatientFilter final : public Filter {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit PatientFilter(Parameters) {}
  DisparityMap run(const DisparityMap& map, const ImagePair&,
                   const Context& context) const override {
    context.figure("begun", 1);
    while (!context.cancelled()) std::this_thread::yield();
    context.throw_if_cancelled();
    return map;
  }
};

struct Starter : Observer {
  void figure(const StagePlace&, const std::string&, double) override { begun.set_value(); }
  std::promise<void> begun;
};

}  // namespace

TEST_CASE("a stage with a long loop of its own can ask whether the run is cancelled") {
  Registry registry = Registry::with_builtins();
  registry.add<PatientFilter>("patient", "Waits until the run is cancelled.");
  const LoadedPipeline loaded = load_pipeline(XGM_SOURCE_DIR "/pipelines/sgm8.yaml", registry,
                                              {{"postprocess", "[patient]"}});
  REQUIRE(loaded.pipeline.has_value());
  std::stop_source stop;
  Starter observer;
  const MatchRequest request{
      xgm::testing::shifted_pair({20, 10}, 2, 1), DisparityRange::uniform({20, 10}, {0, 5}), {}};
  std::thread other([&] {
    observer.begun.get_future().wait();
    stop.request_stop();
  });
  CHECK_THROWS_AS(loaded.pipeline->run(request, {.observer = &observer, .stop = stop.get_token()}),
                  Cancelled);
  other.join();
  CHECK_FALSE(Context{}.cancelled());
}
