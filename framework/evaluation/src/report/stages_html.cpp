// SPDX-License-Identifier: Apache-2.0
#include "report/stages_html.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "report/html.hpp"
#include "report/record_html.hpp"
#include "xgm/evaluation/report.hpp"

namespace xgm::report {
namespace {

struct Call {
  std::string path;
  std::string kind;
  std::string plugin;
  double depth = 0;    ///< number of stages around
  double seconds = 0;  ///< stages inside included
  double own = 0;      ///< without them
  double bytes = 0;
  std::string same_as;  ///< path of the call whose result it was given
};

/// Calls in the order in which they began; what only reported figures is no stage.
std::vector<Call> calls_of(const Json& record) {
  std::vector<Call> calls;
  if (!record.contains("stages")) return calls;
  for (const Json& stage : record.at("stages")) {
    const double seconds = number_at(stage, "/seconds");
    if (!std::isfinite(seconds)) continue;
    calls.push_back({text_at(stage, "/stage"), text_at(stage, "/kind"), text_at(stage, "/plugin"),
                     number_at(stage, "/depth"), seconds, seconds, number_at(stage, "/bytes"),
                     text_at(stage, "/same_as")});
  }
  return calls;
}

/// A stage's own time is what is left without the stages right inside it.
void find_own_times(std::vector<Call>& calls) {
  std::vector<Call*> open;
  for (Call& call : calls) {
    while (!open.empty() && open.back()->depth >= call.depth) open.pop_back();
    if (!open.empty()) open.back()->own -= call.seconds;
    open.push_back(&call);
  }
  for (Call& call : calls) call.own = std::max(0.0, call.own);
}

struct Group {
  std::string kind, plugin;
  int calls = 0;
  double own = 0;
  double max_bytes = 0;
};

std::vector<Group> groups_of(const std::vector<Call>& calls) {
  std::vector<Group> groups;
  for (const Call& call : calls) {
    if (!call.same_as.empty()) continue;
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& known) {
      return known.plugin == call.plugin && known.kind == call.kind;
    });
    if (group == groups.end()) group = groups.insert(groups.end(), Group{call.kind, call.plugin});
    ++group->calls;
    group->own += call.own;
    if (call.bytes > group->max_bytes) group->max_bytes = call.bytes;
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.own > b.own; });
  return groups;
}

std::string bar(double share) {
  return "<span class=\"meter\"><span style=\"width:" + number(100 * share, 1) +
         "%\"></span></span>";
}

std::string by_plugin(const std::vector<Group>& groups) {
  double sum = 0;
  for (const Group& group : groups) sum += group.own;
  std::vector<Row> rows;
  for (const Group& group : groups) {
    const double share = sum > 0 ? group.own / sum : 0;
    rows.push_back({html_text(group.plugin) + " <small>" + html_text(group.kind) + "</small>",
                    seconds(group.own) + bar(share), std::to_string(group.calls),
                    megabytes(group.max_bytes)});
  }
  return table({"Stage", "Time", "Calls", "Largest result"}, rows);
}

std::string every_call(const std::vector<Call>& calls) {
  std::vector<Row> rows;
  for (const Call& call : calls) {
    const std::string same = call.same_as.empty() ? "" : ", found by " + call.same_as;
    rows.push_back({html_text(call.path), html_text(call.plugin + same), seconds(call.seconds),
                    seconds(call.own), megabytes(call.bytes)});
  }
  return table({"Path", "Plugin", "Time", "Without stages inside", "Result"}, rows);
}

}  // namespace

std::string stages_html(const Json& record) {
  std::vector<Call> calls = calls_of(record);
  if (calls.empty()) return "";
  find_own_times(calls);
  return "<h4>Time and memory</h4>" + by_plugin(groups_of(calls)) +
         details("Every call of a stage", every_call(calls));
}

double seconds_of(const Json& record, const std::string& stage_path) {
  for (const Call& call : calls_of(record)) {
    if (call.path == stage_path) return call.seconds;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace xgm::report
