// SPDX-License-Identifier: Apache-2.0
// Contracts of the stages that look at images alone: preprocess and penalty.
#include <cmath>

#include "contract_support.hpp"

namespace xgm::testing {

using namespace detail;

namespace {

void expect_sound_view(Report& report, const Image& image, cv::Size size) {
  report.expect(image.planes.size() == 1 || image.planes.size() == 3,
                "an image does not have one or three planes");
  bool sized = image.valid.empty() || image.valid.size() == size;
  for (const cv::Mat1f& plane : image.planes) sized = sized && plane.size() == size;
  report.expect(sized, "planes or masks do not have the base image's size");
  if (!sized) return;
  for (const cv::Mat1f& plane : image.planes)
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x)
        report.expect(std::isfinite(plane(y, x)) || !image.is_valid(y, x),
                      "a valid pixel has no finite level", y, x);
}

void check_preprocess_on(Report& report, const Preprocess& stage, const ImagePair& pair) {
  const Bytes before = bytes_of(pair);
  const ImagePair result = run_with_threads(report, [&] { return stage.run(pair, Context{}); });
  report.expect(bytes_of(pair) == before, "the images were changed in place");
  expect_sound_view(report, result.base, pair.size());
  expect_sound_view(report, result.match, pair.size());
  const cv::Mat1b& mask = result.base.valid;
  if (!mask.empty() && mask.size() != pair.size()) return;
  for (int y = 0; y < pair.size().height; ++y)
    for (int x = 0; x < pair.size().width; ++x)
      report.expect(pair.base.is_valid(y, x) || !result.base.is_valid(y, x),
                    "a masked base pixel is valid afterwards", y, x);
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

void expect_table(Report& report, const PenaltyTable& table) {
  report.expect(table.base_classes >= 1 && table.base_classes <= 256 && table.match_classes >= 1 &&
                    table.match_classes <= 256,
                "the number of classes is not in 1 to 256");
  report.expect(static_cast<int>(table.entries.size()) == table.base_classes * table.match_classes,
                "the table does not have an entry for each pair of classes");
  for (const PenaltyPair& entry : table.entries)
    report.expect(0 <= entry.p1 && entry.p1 <= entry.p2, "not 0 <= p1 <= p2");
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
  report.expect(field != nullptr, "there is no penalty field");
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
    expect_table(report, table);
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

Violations check_preprocess(const Preprocess& stage) {
  Report report;
  for (const Input& input : inputs())
    report.with(input.name, [&] { check_preprocess_on(report, stage, input.pair); });
  return report.take();
}

Violations check_penalty(const Penalty& stage) {
  Report report;
  for (const Input& input : inputs())
    report.with(input.name, [&] { check_penalty_on(report, stage, input.pair); });
  return report.take();
}

}  // namespace xgm::testing
