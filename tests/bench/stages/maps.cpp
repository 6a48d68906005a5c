// SPDX-License-Identifier: Apache-2.0
// The stages that handle every pixel of a map, through the interface that pipelines use.
#include "bench/stages/inputs.hpp"

namespace xgm::bench {
namespace {

/// run() is one run of the stage, on one thread.
template <class Kind, class Run>
void add(const std::string& name, const std::string& yaml, Run run) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    const ThreadLimit one(1);
    const auto made = stage<Kind>(yaml);
    const std::int64_t pixels = run(*made);  // makes the inputs, too
    for (auto _ : state) run(*made);
    count(state, "pixels", pixels);
  })->Unit(benchmark::kMillisecond);
}

void add_filter(const std::string& name, const std::string& yaml) {
  add<Filter>("filter/" + name, yaml, [](const Filter& filter) {
    const DisparityMap map = filter.run(maps().forward, pair(), {});
    benchmark::DoNotOptimize(map.status.data);
    return std::int64_t{map.size().area()};
  });
}

/// Holes, as the consistency check leaves them.
void add_interpolation() {
  add<Filter>("filter/interpolation", "discontinuity_preserving_interpolation",
              [](const Filter& filter) {
                static const MatchResult checked = stage<Consistency>("lrrl")->run(maps(), {});
                const DisparityMap map = filter.run(checked.forward, pair(), {});
                benchmark::DoNotOptimize(map.status.data);
                return std::int64_t{map.size().area()};
              });
}

/// The map is that of the coarser level: pixels of the finer one are told.
void add_search_range(const std::string& name, const std::string& yaml) {
  add<SearchRange>("search_range/" + name, yaml, [](const SearchRange& search) {
    const cv::Size fine = pair().size() * 2;
    const auto limits = DisparityRange::uniform(fine, {0, 128});
    const DisparityRange range = search.run(maps().forward, limits, {});
    benchmark::DoNotOptimize(range.hull().end);
    return std::int64_t{fine.area()};
  });
}

}  // namespace

void register_maps() {
  add_filter("median3", "{type: median, window: 3}");
  add_filter("joint_bilateral", "joint_bilateral");
  add_filter("peak_removal", "{type: peak_removal, min_size: 20}");
  add_interpolation();
  add<Consistency>("consistency/lrrl", "lrrl", [](const Consistency& check) {
    const MatchResult checked = check.run(maps(), {});
    benchmark::DoNotOptimize(checked.forward.status.data);
    return std::int64_t{2} * checked.forward.size().area();
  });
  add_search_range("percentile41", "{type: percentile, window: 41, low: 5, high: 95}");
  add_search_range("min_max7", "{type: min_max, window: 7}");
  add_search_range("median_window", "median_window");
}

}  // namespace xgm::bench
