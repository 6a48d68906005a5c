// SPDX-License-Identifier: Apache-2.0
// The tables of surface benches.
#include "bench/surface_columns.hpp"
#include "xgm/plugin/version.hpp"

namespace xgm::geo {
namespace {

std::vector<std::string> header(std::vector<std::string> names,
                                const std::vector<SurfaceColumn>& columns) {
  for (const SurfaceColumn& column : columns) names.push_back(column.head);
  return names;
}

std::vector<Best> directions(const std::vector<SurfaceColumn>& columns) {
  std::vector<Best> best;
  for (const SurfaceColumn& column : columns) best.push_back(column.best);
  return best;
}

TableCell cell_of(const SurfaceColumn& column, double value) {
  return {figure_text(column.scale * value, column.decimals)};
}

void note_failures(Table& table, const SurfaceBenchResult& result, const std::string& set) {
  std::size_t not_run = 0;
  const auto& [output, pipelines, scenes, program, threads] = result.request;
  for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
    if (scenes[scene].set != set) continue;
    for (std::size_t i = 0; i < pipelines.size(); ++i) {
      const SurfaceCell& cell = result.at(i, scene);
      if (cell.state == CellState::not_run) ++not_run;
      if (cell.state != CellState::failed) continue;
      table.notes.push_back(pipelines[i].name + " failed on " + scenes[scene].name + ": " +
                            cell.failure);
    }
  }
  if (not_run > 0) table.notes.push_back(std::to_string(not_run) + " runs are still to be done");
}

}  // namespace

Table average_table(const SurfaceBenchResult& result, const std::string& set) {
  const std::vector<SurfaceColumn> columns = table_columns(result);
  Table table{.title = set, .names = 2, .header = header({"pipeline", "scenes"}, columns)};
  std::vector<bool> ranked;
  for (std::size_t i = 0; i < result.request.pipelines.size(); ++i) {
    const SurfaceAverage mean = average(result, i, set, columns);
    std::string count = std::to_string(mean.scenes);
    if (mean.scenes != mean.of) count += " of " + std::to_string(mean.of);
    auto& row = table.rows.emplace_back();
    row = {{result.request.pipelines[i].name}, {count + (mean.comparable ? "" : " !")}};
    for (std::size_t c = 0; c < columns.size(); ++c) {
      row.push_back(cell_of(columns[c], mean.figures[c]));
    }
    ranked.push_back(mean.comparable);
    if (i == 0) table.title += ": average of " + std::to_string(mean.of) + " scenes";
  }
  std::vector<std::vector<TableCell>*> rows;
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    if (ranked[i]) rows.push_back(&table.rows[i]);
  }
  if (rows.size() < table.rows.size())
    table.notes.push_back("! lacks scenes that others have: not comparable, and not ranked");
  mark_best(rows, table.names, directions(columns));
  note_failures(table, result, set);
  return table;
}

Table scene_table(const SurfaceBenchResult& result, const std::string& set) {
  const std::vector<SurfaceColumn> columns = table_columns(result);
  const std::size_t pipelines = result.request.pipelines.size();
  Table table{
      .title = set + ": scenes", .names = 2, .header = header({"scene", "pipeline"}, columns)};
  for (std::size_t scene = 0; scene < result.request.scenes.size(); ++scene) {
    if (result.request.scenes[scene].set != set) continue;
    const std::size_t first = table.rows.size();
    for (std::size_t i = 0; i < pipelines; ++i) {
      const SurfaceCell& cell = result.at(i, scene);
      const bool done = cell.state == CellState::done;
      auto& row = table.rows.emplace_back();
      row = {{result.request.scenes[scene].name}, {result.request.pipelines[i].name}};
      for (const SurfaceColumn& column : columns) {
        row.push_back(done ? cell_of(column, column.value(cell)) : TableCell{kNoFigure});
      }
    }
    std::vector<std::vector<TableCell>*> rows;
    for (std::size_t i = 0; i < pipelines; ++i) rows.push_back(&table.rows[first + i]);
    mark_best(rows, table.names, directions(columns));
    for (std::size_t i = 0; i < pipelines; ++i) {
      const CellState state = result.at(i, scene).state;
      if (state != CellState::done) (*rows[i])[table.names].text = state_text(state);
    }
  }
  note_failures(table, result, set);
  return table;
}

Table relation_table(const SurfaceBenchResult& result) {
  std::vector<SurfaceColumn> of_surfaces, of_disparities;
  for (const SurfaceColumn& column : surface_columns()) {
    if (column.key.rfind("disparity_", 0) == 0) {
      of_disparities.push_back(column);
    } else if (column.key.rfind("levelled_", 0) == 0 || column.key == "coverage") {
      of_surfaces.push_back(column);
    }
  }
  const auto values = [&](const SurfaceColumn& column) {
    std::vector<double> all;
    for (const SurfaceCell& cell : result.cells) {
      if (cell.state == CellState::done) all.push_back(column.value(cell));
    }
    return all;
  };
  Table table{.title = "How figures of surfaces go with those of disparities: rank correlation",
              .names = 1,
              .header = header({"disparities"}, of_surfaces)};
  for (const SurfaceColumn& row : of_disparities) {
    auto& cells = table.rows.emplace_back();
    cells = {{row.head}};
    for (const SurfaceColumn& column : of_surfaces) {
      cells.push_back({figure_text(rank_correlation(values(row), values(column)), 2)});
    }
  }
  return table;
}

std::vector<std::string> explanations(const SurfaceBenchResult& result) {
  std::vector<std::string> texts{
      "dz is surface minus truth. Of the cells that have a true height and are shown by two "
      "images, "
      "complete: |dz| below 1 m, covered: have a height; both in percent. median: of |dz|, m. "
      "RMSE: "
      "m. bias: median of dz, m. lev.: the same with the bias taken out.",
      "spikes: share of the cells on flats that are more than 5 m off, in percent, bias taken out.",
      "search px: disparities searched, mean of the pixels; s: seconds of the run (" +
          std::to_string(result.request.threads) +
          (result.request.threads == 1 ? " thread" : " threads") +
          "), MB: the most memory its process had.",
      "Averages are means over scenes; MB is the largest.", "Made with xgm " XGM_VERSION "."};
  if (knows_disparities(result)) {
    texts.insert(texts.begin() + 2,
                 "d: of the disparities of the same runs, non-occluded pixels. total 1: without a "
                 "disparity, or more than 1 px off, in percent; avg err: px.");
  }
  return texts;
}

}  // namespace xgm::geo
