// SPDX-License-Identifier: Apache-2.0
#include "report/record_html.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "report/html.hpp"
#include "report/yaml_text.hpp"
#include "xgm/base/scalar.hpp"
#include "xgm/base/shell.hpp"
#include "xgm/evaluation/report.hpp"

namespace xgm::report {
namespace {

const Json kNothing;

const Json* part_of(const Json& value, const std::string& name) {
  if (!value.is_array()) return value.find(name);
  const auto index = to_number<std::size_t>(name);
  return index && *index < value.size() ? &value.elements()[*index] : nullptr;
}

/// What a JSON pointer (RFC 6901) such as "/truth/0/region" leads to.
const Json& at(const Json& record, const std::string& pointer) {
  const Json* part = &record;
  for (std::size_t i = 0; i < pointer.size() && part != nullptr;) {
    const std::size_t end = std::min(pointer.find('/', i + 1), pointer.size());
    part = part_of(*part, pointer.substr(i + 1, end - i - 1));
    i = end;
  }
  return part != nullptr ? *part : kNothing;
}

/// The part of the truth that maps are ranked by.
const Json& ranking_region(const Json& record) {
  const Json& regions = at(record, "/truth");
  for (const Json& region : regions) {
    if (text_at(region, "/region") == "non-occluded") return region;
  }
  return regions.is_array() && !regions.empty() ? regions.elements().front() : kNothing;
}

std::string command_line(const Json& record) {
  std::string text = "pipeline";
  for (const Json& argument : at(record, "/command_line")) {
    if (argument.is_string()) text += " " + shell_word(argument.text());
  }
  return "<pre>" + html_text(text) + "</pre>";
}

std::string versions(const Json& record) {
  std::vector<Row> rows;
  const Json& versions = at(record, "/versions");
  if (!versions.is_object()) return "";
  for (const auto& [name, version] : versions.members()) {
    if (version.is_string()) rows.push_back({html_text(name), html_text(version.text())});
  }
  return table({"Program", "Version"}, rows);
}

std::string inputs(const Json& record) {
  std::vector<Row> rows;
  for (const Json& input : at(record, "/scene/inputs")) {
    rows.push_back({html_text(text_at(input, "/role")), html_text(text_at(input, "/file")),
                    megabytes(number_at(input, "/bytes")),
                    "<code>" + html_text(text_at(input, "/fnv1a64")) + "</code>"});
  }
  return rows.empty() ? "" : table({"Read", "File", "Size", "FNV-1a"}, rows);
}

void add_thresholds(const Json& regions, std::vector<Row>& rows) {
  const Json& thresholds = at(regions, "/0/thresholds");
  for (std::size_t i = 0; i < thresholds.size(); ++i) {
    const std::string pointer = "/thresholds/" + std::to_string(i);
    const double delta = number_at(regions, "/0" + pointer + "/delta_px");
    Row& row = rows.emplace_back();
    row.push_back("total &gt; " + number(delta, 1) + " px");
    for (const Json& region : regions)
      row.push_back(percent(number_at(region, pointer + "/total")));
  }
}

}  // namespace

double number_at(const Json& record, const std::string& pointer) {
  const Json& value = at(record, pointer);
  return value.is_number() ? value.number() : std::numeric_limits<double>::quiet_NaN();
}

std::string text_at(const Json& record, const std::string& pointer) {
  const Json& value = at(record, pointer);
  return value.is_string() ? value.text() : "";
}

double total_error(const Json& record, double delta) {
  for (const Json& score : at(ranking_region(record), "/thresholds")) {
    if (number_at(score, "/delta_px") == delta) return number_at(score, "/total");
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double average_error(const Json& record) {
  return number_at(ranking_region(record), "/average_error_px");
}

std::string facts_html(const Json& record) {
  if (!record.is_object()) return "";
  const auto whole = [&](const char* pointer) { return number(number_at(record, pointer), 0); };
  std::vector<std::pair<std::string, std::string>> facts;
  facts.emplace_back("Image", whole("/scene/width") + " × " + whole("/scene/height") + " px");
  facts.emplace_back("Disparities searched",
                     whole("/disparities/first") + " to " + whole("/disparities/last") + " px");
  facts.emplace_back("Pixels with a disparity", percent(number_at(record, "/valid_share")));
  if (!at(record, "/truth").empty()) {
    const std::string region = text_at(ranking_region(record), "/region");
    facts.emplace_back("Total error > 1 px, " + region, percent(total_error(record, 1)));
    facts.emplace_back("Average error, " + region, number(average_error(record), 3) + " px");
  }
  const std::string threads = whole("/threads");
  facts.emplace_back("Matching, " + threads + (threads == "1" ? " thread" : " threads"),
                     seconds(number_at(record, "/seconds/matching")));
  facts.emplace_back("Memory at most", megabytes(number_at(record, "/peak_memory_bytes")));
  return facts_list(facts);
}

std::string evaluation_html(const Json& record) {
  const Json& regions = at(record, "/truth");
  if (regions.empty()) return "";
  Row head{"Figure"};
  for (const Json& region : regions) head.push_back(html_text(text_at(region, "/region")));
  std::vector<Row> rows;
  const auto add = [&](const std::string& name, const char* pointer, auto format) {
    Row& row = rows.emplace_back(Row{name});
    for (const Json& region : regions) row.push_back(format(number_at(region, pointer)));
  };
  const auto pixels = [](double value) { return number(value, 3) + " px"; };
  add("pixels judged", "/judged_pixels", [](double value) { return number(value, 0); });
  add("invalid: no disparity", "/invalid", percent);
  add_thresholds(regions, rows);
  add("D1", "/d1", percent);
  add("average error", "/average_error_px", pixels);
  add("RMS", "/rms_px", pixels);
  for (const char* level : {"50", "90", "95", "99"}) {
    add(std::string("A") + level, (std::string("/a") + level + "_px").c_str(), pixels);
  }
  return "<h4>Compared with the truth</h4>" + table(head, rows) +
         "<p class=\"note\">Total: no disparity, or off by more than so many pixels. A90: 90 % of "
         "the errors are at most this. D1: off by more than 3 px and 5 %, or none. Errors are over "
         "pixels that have a disparity and a truth.</p>\n";
}

std::string configuration_html(const Json& record) {
  if (!record.is_object()) return "";
  const Json& resolved = at(record, "/pipeline/resolved");
  std::string html;
  if (resolved.is_object()) {
    html += details("Pipeline with every parameter",
                    "<p class=\"note\">From " + html_text(text_at(record, "/pipeline/file")) +
                        ". A pipeline itself: save it as a .yaml file to run it again.</p><pre>" +
                        html_text(yaml_text(resolved)) + "</pre>");
  }
  return html + details("Command line, versions, files read",
                        command_line(record) + versions(record) + inputs(record));
}

std::string warnings_html(const Json& record) {
  const Json& warnings = at(record, "/warnings");
  if (warnings.empty()) return "";
  std::string html = "<div class=\"warnings\"><h4>Warnings</h4><ul>";
  for (const Json& warning : warnings) {
    if (warning.is_string()) html += "<li>" + html_text(warning.text()) + "</li>";
  }
  return html + "</ul></div>\n";
}

}  // namespace xgm::report
