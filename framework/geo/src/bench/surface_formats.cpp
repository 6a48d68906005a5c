// SPDX-License-Identifier: Apache-2.0
// A surface bench in several formats.
#include <cmath>
#include <filesystem>

#include "bench/surface_columns.hpp"
#include "xgm/base/json.hpp"
#include "xgm/evaluation/record_json.hpp"
#include "xgm/evaluation/report.hpp"
#include "xgm/plugin/version.hpp"

namespace xgm::geo {
namespace {

constexpr const char* kInterrupted = "Interrupted: not all has been run.";

Json figures_json(const std::vector<SurfaceColumn>& columns, const std::vector<double>& figures) {
  Json json = Json::object();
  for (std::size_t c = 0; c < columns.size(); ++c) json[columns[c].key] = figures[c];
  return json;
}

std::vector<double> figures_of(const std::vector<SurfaceColumn>& columns, const SurfaceCell& cell) {
  std::vector<double> figures;
  for (const SurfaceColumn& column : columns) {
    figures.push_back(cell.state == CellState::done ? column.value(cell) : NAN);
  }
  return figures;
}

std::string csv_line(const std::vector<std::string>& names, const std::vector<double>& figures,
                     const std::string& failure) {
  std::string line;
  for (const std::string& name : names) line += csv_field(name) + ",";
  for (const double figure : figures) line += csv_number(figure) + ",";
  return line + csv_field(failure) + "\n";
}

/// A picture of every surface of a scene, side by side.
std::string pictures(const SurfaceBenchResult& result, std::size_t scene) {
  const auto& request = result.request;
  std::string html = "<h2>" +
                     html_text(request.scenes[scene].set + ", " + request.scenes[scene].name) +
                     "</h2>\n<div style=\"display:flex;flex-wrap:wrap;gap:1em\">\n";
  for (std::size_t i = 0; i < request.pipelines.size(); ++i) {
    if (result.at(i, scene).state != CellState::done) continue;
    const auto file = std::filesystem::path(cell_folder(request, i, scene)) / "dsm.png";
    const std::string link = std::filesystem::relative(file, request.output).generic_string();
    html += "<figure style=\"margin:0\"><a href=\"" + html_text(link) +
            "\"><img width=\"360\" alt=\"\" src=\"" + html_text(link) + "\"></a><figcaption>" +
            html_text(request.pipelines[i].name) + "</figcaption></figure>\n";
  }
  return html + "</div>\n";
}

}  // namespace

std::string surface_bench_text(const SurfaceBenchResult& result) {
  std::string out = "shares in %, heights in m; " + std::to_string(result.request.threads) +
                    (result.request.threads == 1 ? " thread\n" : " threads\n");
  for (const std::string& set : sets(result)) {
    out += (set == sets(result).front() ? "" : "\n") + table_text(average_table(result, set));
  }
  return out + "* best of its column\n";
}

std::string surface_bench_markdown(const SurfaceBenchResult& result) {
  std::string out = "# Bench of surfaces\n\n";
  if (result.interrupted) out += std::string("**") + kInterrupted + "**\n\n";
  for (const std::string& text : explanations(result)) out += markdown_text(text) + "\n";
  for (const std::string& set : sets(result)) out += table_markdown(average_table(result, set));
  if (knows_disparities(result)) out += table_markdown(relation_table(result));
  for (const std::string& set : sets(result)) out += table_markdown(scene_table(result, set));
  return out;
}

std::string surface_bench_html(const SurfaceBenchResult& result) {
  std::string out =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Bench of "
      "surfaces</title>\n<style>body{font-family:sans-serif;margin:1em}</style>\n";
  out += kTableStyle;
  out += "</head><body>\n<h1>Bench of surfaces</h1>\n";
  if (result.interrupted) out += std::string("<p><b>") + kInterrupted + "</b></p>\n";
  out += "<p>";
  for (const std::string& text : explanations(result)) out += html_text(text) + "\n";
  out += "</p>\n";
  for (const std::string& set : sets(result)) out += table_html(average_table(result, set));
  if (knows_disparities(result)) out += table_html(relation_table(result));
  for (const std::string& set : sets(result)) {
    out += "<details><summary>" + html_text(set) + ", scene by scene</summary>\n" +
           table_html(scene_table(result, set)) + "</details>\n";
  }
  for (std::size_t i = 0; i < result.request.scenes.size(); ++i) out += pictures(result, i);
  return out + "</body></html>\n";
}

std::string surface_bench_csv(const SurfaceBenchResult& result) {
  const std::vector<SurfaceColumn> columns = surface_columns();
  std::string out = "kind,set,scene,pipeline,state,scenes";
  for (const SurfaceColumn& column : columns) out += "," + column.key;
  out += ",failure\n";
  const auto& request = result.request;
  for (const std::string& set : sets(result)) {
    for (std::size_t i = 0; i < request.pipelines.size(); ++i) {
      const SurfaceAverage mean = average(result, i, set, columns);
      const char* const state = mean.scenes > 0 ? "done" : "not run";
      out += csv_line(
          {"average", set, "", request.pipelines[i].name, state, std::to_string(mean.scenes)},
          mean.figures, "");
    }
  }
  for (std::size_t scene = 0; scene < request.scenes.size(); ++scene) {
    for (std::size_t i = 0; i < request.pipelines.size(); ++i) {
      const SurfaceCell& cell = result.at(i, scene);
      out += csv_line({"scene", request.scenes[scene].set, request.scenes[scene].name,
                       request.pipelines[i].name, state_text(cell.state), "1"},
                      figures_of(columns, cell), cell.failure);
    }
  }
  return out;
}

std::string surface_bench_json(const SurfaceBenchResult& result) {
  const std::vector<SurfaceColumn> columns = surface_columns();
  const auto& request = result.request;
  Json pipelines = Json::array(), averages = Json::array(), cells = Json::array();
  for (const BenchPipeline& pipeline : request.pipelines) {
    pipelines.push_back({{"name", pipeline.name},
                         {"file", pipeline.file},
                         {"overrides", to_json(pipeline.overrides)},
                         {"resolved", Json::parse(pipeline.resolved)}});
  }
  for (const std::string& set : sets(result)) {
    for (std::size_t i = 0; i < request.pipelines.size(); ++i) {
      const SurfaceAverage mean = average(result, i, set, columns);
      averages.push_back({{"set", set},
                          {"pipeline", request.pipelines[i].name},
                          {"scenes", mean.scenes},
                          {"of", mean.of},
                          {"comparable", mean.comparable},
                          {"figures", figures_json(columns, mean.figures)}});
    }
  }
  for (std::size_t scene = 0; scene < request.scenes.size(); ++scene) {
    for (std::size_t i = 0; i < request.pipelines.size(); ++i) {
      const SurfaceCell& cell = result.at(i, scene);
      Json json = {{"set", request.scenes[scene].set},
                   {"scene", request.scenes[scene].name},
                   {"pipeline", request.pipelines[i].name},
                   {"folder", cell_folder(request, i, scene)},
                   {"state", state_text(cell.state)}};
      if (cell.state == CellState::failed) json["failure"] = cell.failure;
      if (cell.state == CellState::done)
        json["figures"] = figures_json(columns, figures_of(columns, cell));
      cells.push_back(std::move(json));
    }
  }
  const Json json = {{"format", 1},
                     {"xgm", XGM_VERSION},
                     {"interrupted", result.interrupted},
                     {"threads", request.threads},
                     {"pipelines", std::move(pipelines)},
                     {"averages", std::move(averages)},
                     {"cells", std::move(cells)}};
  return json.dump(2) + "\n";
}

}  // namespace xgm::geo
