// SPDX-License-Identifier: Apache-2.0
#include "xgm/base/json.hpp"
#include "xgm/evaluation/evaluation_json.hpp"
#include "xgm/evaluation/record_json.hpp"
#include "xgm/evaluation/run_record.hpp"

namespace xgm {
namespace {

constexpr int kFormat = 1;  // raised when a reader of run.json would have to change

Json statuses(const RunRecord& record) {
  Json shares;
  for (int i = 0; i < kStatusCount; ++i) {
    shares[std::string(to_string(static_cast<Status>(i)))] =
        record.status_shares[static_cast<std::size_t>(i)];
  }
  return shares;
}

Json dumps(const RunRecord& record) {
  Json list = Json::array();
  for (const DumpedFile& dump : record.dumps) {
    Json entry = {{"file", dump.file}, {"stage", dump.stage_path}};
    if (dump.file.ends_with(".npy")) entry["first_disparity"] = dump.first_disparity;
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace

std::string to_json(const RunRecord& record) {
  Json json;
  json["format"] = kFormat;
  json["versions"] = versions_json();
  json["command_line"] = record.command_line;
  json["pipeline"] = {{"file", record.pipeline_file},
                      {"overrides", to_json(record.overrides)},
                      {"resolved", Json::parse(record.resolved_pipeline)}};
  json["scene"] = {{"name", record.scene},
                   {"width", record.size.width},
                   {"height", record.size.height},
                   {"inputs", to_json(record.inputs)}};
  json["disparities"] = {{"first", record.disparities.begin},
                         {"last", record.disparities.end - 1},
                         {"from", record.disparities_from}};
  json["threads"] = record.threads;
  json["seconds"] = {{"reading", record.reading_seconds}, {"matching", record.matching_seconds}};
  json["peak_memory_bytes"] = record.peak_memory_bytes;
  json["valid_share"] = record.valid_share;
  json["status_shares"] = statuses(record);
  if (!record.truth.empty()) json["truth"] = to_json(record.truth);
  json["stages"] = to_json(record.stages);
  if (!record.reused.empty()) {
    json["reused"] = reused_json(record.reused_from, record.reused);
  }
  json["warnings"] = record.warnings;
  if (!record.dumps.empty()) json["dumps"] = dumps(record);
  if (!record.outputs.empty()) json["outputs"] = to_json(record.outputs);
  return json.dump(2) + "\n";
}

}  // namespace xgm
