// SPDX-License-Identifier: Apache-2.0
#include "bench/table.hpp"
#include "xgm/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace xgm {
namespace {

struct Column {
  std::string head;
  int decimals = 2;
  Best best = Best::lowest;
  std::function<double(const BenchCell&)> value;
};

constexpr double kPercent = 100;
constexpr double kMega = 1e6;

/// A figure of the region that is judged; NaN where there is no truth.
template <class Figure>
std::function<double(const BenchCell&)> by_truth(const BenchRules& rules, Figure figure) {
  return [&rules, figure](const BenchCell& cell) {
    const Evaluation* evaluation = judged(cell, rules);
    return evaluation != nullptr ? figure(*evaluation) : std::numeric_limits<double>::quiet_NaN();
  };
}

bool any_cell(const BenchResult& result, bool with_truth) {
  return std::any_of(result.cells.begin(), result.cells.end(), [&](const BenchCell& cell) {
    return cell.state == CellState::done && (judged(cell, result.rules) != nullptr) == with_truth;
  });
}

void add_truth_columns(std::vector<Column>& columns, const BenchRules& rules) {
  const auto add = [&](const std::string& head, auto figure) {
    columns.push_back({.head = head, .value = by_truth(rules, figure)});
  };
  add("avg err", [](const Evaluation& e) { return e.average_error; });
  add("invalid", [](const Evaluation& e) { return kPercent * e.invalid; });
  for (std::size_t i = 0; i < rules.thresholds.size(); ++i) {
    const std::string delta = short_number(rules.thresholds[i]);
    add("bad " + delta, [i](const Evaluation& e) { return kPercent * e.at.at(i).bad; });
    add("total " + delta, [i](const Evaluation& e) { return kPercent * e.at.at(i).total; });
  }
}

/// Of figures of `result`, which must outlive them.
std::vector<Column> columns(const BenchResult& result) {
  std::vector<Column> columns;
  if (any_cell(result, true)) add_truth_columns(columns, result.rules);
  if (any_cell(result, false) || columns.empty()) {
    columns.push_back({.head = "density", .best = Best::none, .value = [](const BenchCell& cell) {
                         return kPercent * cell.density;
                       }});
  }
  columns.push_back({.head = "s", .value = [](const BenchCell& cell) { return cell.seconds; }});
  columns.push_back({.head = "MB", .decimals = 0, .value = [](const BenchCell& cell) {
                       return cell.peak_bytes / kMega;
                     }});
  columns.push_back(
      {.head = "MDE/s", .decimals = 1, .best = Best::highest, .value = [](const BenchCell& cell) {
         return cell.evaluations / cell.seconds / kMega;
       }});
  return columns;
}

void add_figures(std::vector<TableCell>& row, const std::vector<Column>& columns,
                 const BenchCell& cell) {
  for (const Column& column : columns) {
    const bool known = cell.state == CellState::done;
    row.push_back({known ? figure_text(column.value(cell), column.decimals) : kNoFigure});
  }
}

std::vector<Best> directions(const std::vector<Column>& columns) {
  std::vector<Best> best;
  for (const Column& column : columns) best.push_back(column.best);
  return best;
}

std::vector<std::vector<TableCell>*> pointers(std::vector<std::vector<TableCell>>& rows) {
  std::vector<std::vector<TableCell>*> list;
  for (auto& row : rows) list.push_back(&row);
  return list;
}

std::vector<std::string> header(std::vector<std::string> names,
                                const std::vector<Column>& columns) {
  for (const Column& column : columns) names.push_back(column.head);
  return names;
}

std::vector<std::size_t> scenes_of(const BenchResult& result, const std::string& set) {
  std::vector<std::size_t> scenes;
  for (std::size_t i = 0; i < result.request.scenes.size(); ++i) {
    if (result.request.scenes[i].set == set) scenes.push_back(i);
  }
  return scenes;
}

/// Why there are rows without figures.
void note_missing(Table& table, const BenchResult& result, const std::vector<std::size_t>& scenes) {
  std::size_t not_run = 0;
  for (const std::size_t scene : scenes) {
    for (std::size_t i = 0; i < result.request.pipelines.size(); ++i) {
      const BenchCell& cell = result.at(i, scene);
      if (cell.state == CellState::not_run) ++not_run;
      if (cell.state != CellState::failed) continue;
      table.notes.push_back(result.request.pipelines[i].name + " failed on " +
                            result.request.scenes[scene].files.name + ": " + cell.failure);
    }
  }
  if (not_run > 0) table.notes.push_back(std::to_string(not_run) + " runs are still to be done");
}

void note_regions(Table& table, const BenchResult& result, const std::vector<std::size_t>& scenes) {
  std::string without_truth, without_region;
  for (const std::size_t scene : scenes) {
    for (std::size_t i = 0; i < result.request.pipelines.size(); ++i) {
      const BenchCell& cell = result.at(i, scene);
      if (cell.state != CellState::done) continue;
      const bool all = !cell.regions.empty() && result.rules.region.empty() &&
                       judged(cell, result.rules) == &cell.regions.front().evaluation;
      std::string* list = judged(cell, result.rules) == nullptr ? &without_truth : nullptr;
      if (all) list = &without_region;
      if (list != nullptr) {
        *list += (list->empty() ? "" : ", ") + result.request.scenes[scene].files.name;
        break;
      }
    }
  }
  if (!without_truth.empty()) {
    const std::string what = result.rules.region.empty() ? "no truth" : "no such region";
    table.notes.push_back(what + " for: " + without_truth);
  }
  if (!without_region.empty()) {
    table.notes.push_back("judged on hidden pixels too, as no mask tells them apart: " +
                          without_region);
  }
}

std::string count(const BenchAverage& average) {
  std::string text = std::to_string(average.scenes);
  if (average.scenes != average.of) text += " of " + std::to_string(average.of);
  return text + (average.comparable ? "" : " !");
}

std::string average_title(const BenchResult& result, const std::string& set,
                          const std::vector<std::size_t>& scenes) {
  std::vector<double> weights;  // of the scenes that any pipeline has done
  for (const std::size_t scene : scenes) {
    bool done = false;
    for (std::size_t i = 0; i < result.request.pipelines.size(); ++i) {
      done = done || result.at(i, scene).state == CellState::done;
    }
    if (done) weights.push_back(result.request.scenes[scene].files.weight);
  }
  const bool even =
      std::adjacent_find(weights.begin(), weights.end(), std::not_equal_to<>()) == weights.end();
  const std::string part =
      weights.size() < scenes.size() ? std::to_string(weights.size()) + " of " : "";
  return set + ": " + (even ? "average" : "weighted average") + " of " + part +
         std::to_string(scenes.size()) + (scenes.size() == 1 ? " scene" : " scenes");
}

}  // namespace

Table average_table(const BenchResult& result, const std::string& set) {
  const std::vector<Column> figures = columns(result);
  const std::vector<std::size_t> scenes = scenes_of(result, set);
  Table table{.title = average_title(result, set, scenes),
              .names = 2,
              .header = header({"pipeline", "scenes"}, figures)};
  std::vector<std::size_t> comparable;
  for (std::size_t i = 0; i < result.request.pipelines.size(); ++i) {
    const BenchAverage mean = average(result, i, set);
    auto& row = table.rows.emplace_back();
    row = {{result.request.pipelines[i].name}, {count(mean)}};
    add_figures(row, figures, mean.figures);
    if (mean.comparable) comparable.push_back(i);
  }
  if (comparable.size() < table.rows.size()) {
    table.notes.push_back("! lacks scenes that others have: not comparable, and not ranked");
  }
  std::vector<std::vector<TableCell>*> rows;
  for (const std::size_t i : comparable) rows.push_back(&table.rows[i]);
  mark_best(rows, table.names, directions(figures));
  note_missing(table, result, scenes);
  note_regions(table, result, scenes);
  return table;
}

Table scene_table(const BenchResult& result, const std::string& set) {
  const std::vector<Column> figures = columns(result);
  Table table{
      .title = set + ": scenes", .names = 2, .header = header({"scene", "pipeline"}, figures)};
  const std::vector<std::size_t> scenes = scenes_of(result, set);
  for (const std::size_t scene : scenes) {
    std::vector<std::vector<TableCell>> rows;
    for (std::size_t i = 0; i < result.request.pipelines.size(); ++i) {
      auto& row = rows.emplace_back();
      row = {{result.request.scenes[scene].files.name}, {result.request.pipelines[i].name}};
      add_figures(row, figures, result.at(i, scene));
    }
    mark_best(pointers(rows), table.names, directions(figures));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const CellState state = result.at(i, scene).state;
      if (state != CellState::done) rows[i][table.names].text = state_text(state);
    }
    table.rows.insert(table.rows.end(), rows.begin(), rows.end());
  }
  note_missing(table, result, scenes);
  return table;
}

}  // namespace xgm
