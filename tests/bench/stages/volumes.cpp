// SPDX-License-Identifier: Apache-2.0
// The stages that handle every cell of a volume, through the interface that pipelines use.
#include <optional>
#include <vector>

#include "bench/stages/inputs.hpp"

namespace xgm::bench {
namespace {

/// A shape that is made when it is needed.
struct NamedShape {
  std::string name;
  std::function<VolumeShapePtr()> make;
};

std::vector<NamedShape> shapes() {
  return {{"dense64", [] { return dense(64); }},
          {"dense128", [] { return dense(128); }},
          {"dense256", [] { return dense(256); }},
          {"ragged32of256", [] { return ragged(); }}};
}

/// Costs and sums, 1.8 MB, stay in the second-level cache of most processors: what is left is the
/// path step and what is done around it.
NamedShape cached() {
  return {"cached256", [] { return dense(256, {96, 24}); }};
}

/// One thread, whatever the machine has: to be compared with rooflines of one core.
template <class Body>
void add(const std::string& name, Body body) {
  benchmark::RegisterBenchmark(name.c_str(), [body](benchmark::State& state) {
    const ThreadLimit one(1);
    body(state);
  })->Unit(benchmark::kMillisecond);
}

void add_cost(const NamedShape& shape) {
  add("cost/census5/" + shape.name, [shape](benchmark::State& state) {
    const auto cost = stage<Cost>("{type: census, window: 5}");
    const VolumeShapePtr cells = shape.make();
    for (auto _ : state) benchmark::DoNotOptimize(cost->run(pair(), cells, {}).data());
    count(state, "cells", cells_of(*cells));
  });
}

/// An update is one path direction at one cell.
void add_aggregation(const std::string& name, int directions, const std::string& penalty_name,
                     const std::string& penalty_yaml, const NamedShape& shape) {
  const std::string title =
      "aggregation/" + name + std::to_string(directions) + '/' + penalty_name + '/' + shape.name;
  const std::string yaml = "{type: " + name + ", directions: " + std::to_string(directions) +
                           ", overcounting_correction: true}";
  add(title, [=](benchmark::State& state) {
    const auto aggregation = stage<Aggregation>(yaml);
    const CostVolume costs = costs_of(shape.make());
    const auto penalties = stage<Penalty>(penalty_yaml)->run(pair(costs.shape().size()), {});
    for (auto _ : state) {
      benchmark::DoNotOptimize(aggregation->run(costs, *penalties, {}).data());
    }
    count(state, "updates", cells_of(costs.shape()) * directions);
  });
}

AggregatedVolume sums_of(const VolumeShapePtr& shape) {
  const auto penalties = stage<Penalty>("{type: constant, p1: 24, p2: 96}")->run(pair(), {});
  return stage<Aggregation>("{type: sgm, directions: 4}")->run(costs_of(shape), *penalties, {});
}

void add_selection(const NamedShape& shape) {
  add("selection/wta/" + shape.name, [shape](benchmark::State& state) {
    const auto selection = stage<Selection>("wta");
    const AggregatedVolume sums = sums_of(shape.make());
    for (auto _ : state) benchmark::DoNotOptimize(selection->run(sums, {}).status.data);
    count(state, "cells", cells_of(sums.shape()));
  });
}

void add_refinement(const std::string& name, const NamedShape& shape) {
  add("refinement/" + name + '/' + shape.name, [=](benchmark::State& state) {
    const auto refinement = stage<Refinement>(name);
    const AggregatedVolume sums = sums_of(shape.make());
    const DisparityMap map = stage<Selection>("wta")->run(sums, {});
    for (auto _ : state) benchmark::DoNotOptimize(refinement->run(map, sums, {}).status.data);
    count(state, "pixels", map.size().area());
  });
}

}  // namespace

void register_volumes() {
  const std::vector<std::pair<std::string, std::string>> penalties{
      {"constant", "{type: constant, p1: 24, p2: 96}"},
      // Too large for path costs of 8 bit.
      {"constant_wide", "{type: constant, p1: 100, p2: 400}"},
      {"two_image", "{type: two_image_gradient, p1: 8, p2: 32}"}};
  for (const NamedShape& shape : shapes()) add_cost(shape);
  for (const std::string name : {"sgm", "mgm"}) {
    for (const int directions : {8, 16}) {
      for (const auto& [penalty, yaml] : penalties) {
        for (const NamedShape& shape : shapes()) {
          add_aggregation(name, directions, penalty, yaml, shape);
        }
        add_aggregation(name, directions, penalty, yaml, cached());
      }
    }
  }
  for (const NamedShape& shape : shapes()) add_selection(shape);
  for (const NamedShape& shape : shapes()) add_refinement("parabola", shape);
}

}  // namespace xgm::bench
