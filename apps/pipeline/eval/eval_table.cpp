// SPDX-License-Identifier: Apache-2.0
#include "eval/eval_table.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace xgm::cli {
namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kNarrowest = 8;  // of a column, two blanks in front included

struct Column {
  std::string heading;
  std::vector<std::string> cells;

  std::size_t width() const {
    std::size_t longest = std::max(heading.size() + 2, kNarrowest);
    for (const std::string& cell : cells) longest = std::max(longest, cell.size() + 2);
    return longest;
  }
};

std::string number(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}
std::string percent(double share) { return number(100 * share, 2); }
std::string pixels(double error) { return number(error, 3); }
std::string above(double delta) { return fmt::format("> {:g}", delta); }

/// A line of headings, then the rows. Columns that do not fit beside the first follow below.
std::string lines_of(const Column& first, const std::vector<Column>& columns) {
  std::string text;
  std::size_t label = first.heading.size();
  for (const std::string& cell : first.cells) label = std::max(label, cell.size());
  for (auto begin = columns.begin(); begin != columns.end();) {
    std::size_t width = label + begin->width();
    auto end = begin + 1;
    while (end != columns.end() && width + end->width() <= kWidth) width += (end++)->width();
    std::string line = fmt::format("{:<{}}", first.heading, label);
    for (auto column = begin; column != end; ++column) {
      line += fmt::format("{:>{}}", column->heading, column->width());
    }
    text += line + '\n';
    for (std::size_t row = 0; row < first.cells.size(); ++row) {
      line = fmt::format("{:<{}}", first.cells[row], label);
      for (auto column = begin; column != end; ++column) {
        line += fmt::format("{:>{}}", column->cells[row], column->width());
      }
      text += line + '\n';
    }
    begin = end;
  }
  return text;
}

using Regions = std::vector<RegionEvaluation>;

template <class Text>
Column column(const std::string& heading, const Regions& regions, Text text) {
  Column result{heading, {}};
  for (const RegionEvaluation& region : regions) result.cells.push_back(text(region));
  return result;
}

Column share(const std::string& heading, const Regions& regions, double Evaluation::*figure) {
  return column(heading, regions,
                [&](const auto& region) { return percent(region.evaluation.*figure); });
}

Column error(const std::string& heading, const Regions& regions, double Evaluation::*figure) {
  return column(heading, regions,
                [&](const auto& region) { return pixels(region.evaluation.*figure); });
}

std::vector<Column> at_thresholds(const Regions& regions, double ThresholdScore::*figure) {
  std::vector<Column> columns;
  for (std::size_t i = 0; i < regions.front().evaluation.at.size(); ++i) {
    columns.push_back(
        column(above(regions.front().evaluation.at[i].delta), regions,
               [&](const auto& region) { return percent(region.evaluation.at[i].*figure); }));
  }
  return columns;
}

Column names(const Regions& regions) {
  return column("", regions, [](const auto& region) { return region.region; });
}

std::string totals(const Regions& regions) {
  std::vector<Column> columns{column("pixels", regions, [](const auto& region) {
    return std::to_string(region.evaluation.judged);
  })};
  columns.push_back(share("invalid", regions, &Evaluation::invalid));
  for (Column& total : at_thresholds(regions, &ThresholdScore::total)) columns.push_back(total);
  columns.push_back(share("D1", regions, &Evaluation::d1));
  return "total error: no disparity (invalid), or more than so many px off, % of pixels\n" +
         lines_of(names(regions), columns);
}

std::string bad(const Regions& regions) {
  return "\nbad: with a disparity, but more than so many px off, % of pixels\n" +
         lines_of(names(regions), at_thresholds(regions, &ThresholdScore::bad));
}

std::string errors(const Regions& regions) {
  return "\nerror of the pixels with a disparity, px\n" +
         lines_of(names(regions),
                  {error("average", regions, &Evaluation::average_error),
                   error("RMS", regions, &Evaluation::rms), error("A50", regions, &Evaluation::a50),
                   error("A90", regions, &Evaluation::a90), error("A95", regions, &Evaluation::a95),
                   error("A99", regions, &Evaluation::a99)});
}

/// A curve where 25, 50, 75 and 100 % are kept, and its areas.
void add_curve(std::vector<Column>& columns, const SparsificationCurve& curve, double unit,
               int digits) {
  std::size_t column = 0;
  const std::size_t step = curve.value.size() / 4;
  for (std::size_t end = step; end <= curve.value.size(); end += step) {
    columns[column++].cells.push_back(number(unit * curve.value[end - 1], digits));
  }
  columns[column++].cells.push_back(number(unit * curve.area, digits));
  columns[column].cells.push_back(number(unit * curve.optimal_area, digits));
}

std::string sparsifications(const EvaluationReport& report) {
  if (report.confidence.empty()) return {};
  Column rows{"", {}};
  std::vector<Column> columns;
  for (const char* heading : {"25 %", "50 %", "75 %", "100 %", "area", "optimal"}) {
    columns.push_back({heading, {}});
  }
  for (const auto& [region, sparsification] : report.confidence) {
    for (std::size_t i = 0; i < sparsification.deltas.size(); ++i) {
      rows.cells.push_back(region + " " + above(sparsification.deltas[i]));
      add_curve(columns, sparsification.bad[i], 100, 2);
    }
    rows.cells.push_back(region + " px");
    add_curve(columns, sparsification.average_error, 1, 3);
  }
  return "\nconfidence: bad pixels (%) and average error (px) among so many of the surest\n" +
         lines_of(rows, columns);
}

}  // namespace

std::string table(const EvaluationReport& report) {
  const Regions& regions = report.regions;
  std::string text = totals(regions);
  if (!report.rules.deltas.empty()) text += bad(regions);
  return text + errors(regions) + sparsifications(report);
}

}  // namespace xgm::cli
