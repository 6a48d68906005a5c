// SPDX-License-Identifier: Apache-2.0
// Contracts of the stages that look at images alone: preprocess and penalty.
#include <cmath>

#include "contract_support.hpp"
#include "xgm/base/json.hpp"

namespace xgm::testing {

using namespace detail;

namespace {

void check_preprocess_on(Report& report, const Preprocess& stage, const ImagePair& pair) {
  const Bytes before = bytes_of(pair);
  const ImagePair result = run_with_threads(report, [&] { return stage.run(pair, Context{}); });
  report.expect(bytes_of(pair) == before, "the images were changed in place");
  report.expect_none(Preprocess::fault_of(result, pair, Context{}));
  const cv::Mat1b& mask = result.base.valid;
  if (!mask.empty() && mask.size() != pair.size()) return;
  for (int y = 0; y < pair.size().height; ++y)
    for (int x = 0; x < pair.size().width; ++x)
      report.expect(pair.base.is_valid(y, x) || !result.base.is_valid(y, x),
                    "a masked base pixel is valid afterwards", y, x);
}

/// What is fitted to a scene in one process is the same after a way through text to another one.
void check_restored(Report& report, const Preprocess& stage, const ImagePair& pair) {
  const auto fitted = stage.fitted(PairInMemory(pair), Context{});
  if (fitted == nullptr || fitted->state().empty()) return;
  const auto restored = stage.restored(Json::parse(fitted->state()).dump(), pair.size());
  report.expect(restored != nullptr, "restored() does not know the state() of what it has fitted");
  if (restored == nullptr) return;
  const cv::Point origin(3, 2);
  report.expect(restored->margin() == fitted->margin() &&
                    bytes_of(restored->run(pair, origin)) == bytes_of(fitted->run(pair, origin)),
                "what restored() makes of a state() is not the same");
}

/// The steps of 4, 8 and 16 path directions.
std::vector<Direction> directions() {
  std::vector<Direction> all;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx)
      if (std::abs(dx) == 1 || std::abs(dy) == 1) all.push_back({dx, dy});
  return all;
}

using Classes = std::vector<std::uint8_t>;

/// The classes of all rows, asked for in this order.
Classes classes(const PenaltyField& field, Direction r, cv::Size size, bool upwards) {
  const auto width = static_cast<std::size_t>(size.width);
  Classes all(2 * width * static_cast<std::size_t>(size.height), 255);
  for (int i = 0; i < size.height; ++i) {
    const int y = upwards ? size.height - 1 - i : i;
    const std::span<std::uint8_t> row(&all[2 * width * static_cast<std::size_t>(y)], 2 * width);
    field.classify(r, y, row.first(width), row.last(width));
  }
  return all;
}

void expect_classes(Report& report, const Classes& all, const PenaltyTable& table, int width) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const int column = static_cast<int>(i) % (2 * width), y = static_cast<int>(i) / (2 * width);
    const int classes_there = column < width ? table.base_classes : table.match_classes;
    report.expect(all[i] < classes_there, "a class is not in the table, or was not set", y,
                  column % width);
  }
}

void check_penalty_on(Report& report, const Penalty& stage, const ImagePair& pair) {
  const Bytes before = bytes_of(pair);
  const auto field = stage.run(pair, Context{});
  report.expect_none(Penalty::fault_of(field, pair, Context{}));
  if (field == nullptr) return;
  const auto all_classes = [](const PenaltyField& of, cv::Size size) {
    Classes all;
    for (const Direction r : directions()) {
      const Classes some = classes(of, r, size, false);
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  };
  for (const Direction r : directions()) {
    const PenaltyTable table = field->table(r);
    report.expect_none(fault_of(table));
    const Classes downwards = classes(*field, r, pair.size(), false);
    expect_classes(report, downwards, table, pair.size().width);
    report.expect(downwards == classes(*field, r, pair.size(), true),
                  "classes depend on the order of the rows");
  }
  const Classes expected = all_classes(*field, pair.size());
  for (const int count : {1, 2, 3, 8}) {
    const ThreadLimit threads(count);
    report.expect(all_classes(*stage.run(pair, Context{}), pair.size()) == expected,
                  "the result depends on the number of threads");
  }
  for (const float level : {0.0F, 255.0F})
    report.expect(all_classes(*stage.run(with_levels_under_masks(pair, level), Context{}),
                              pair.size()) == expected,
                  "grey levels of masked pixels matter");
  report.expect(bytes_of(pair) == before, "the images were changed");
}

}  // namespace

Violations check_preprocess(const Preprocess& stage, const Watch& watch) {
  Report report(watch);
  for (const Input& input : inputs()) {
    report.with(input.name, [&] {
      check_preprocess_on(report, stage, input.pair);
      check_restored(report, stage, input.pair);
    });
  }
  return report.take();
}

Violations check_penalty(const Penalty& stage, const Watch& watch) {
  Report report(watch);
  for (const Input& input : inputs())
    report.with(input.name, [&] { check_penalty_on(report, stage, input.pair); });
  return report.take();
}

}  // namespace xgm::testing
