// SPDX-License-Identifier: Apache-2.0
#include "xgm/evaluation/record_json.hpp"

#include <filesystem>
#include <opencv2/core/version.hpp>

#include "xgm/base/error.hpp"
#include "xgm/plugin/handshake.hpp"
#include "xgm/plugin/version.hpp"

namespace xgm {
namespace {

bool stays_in_folder(const std::filesystem::path& file) {
  const std::filesystem::path plain = file.lexically_normal();
  return plain.has_filename() && plain.is_relative() && plain != "." && *plain.begin() != "..";
}

/// A number of bytes; any other number would not survive the conversion.
std::uint64_t to_bytes(const Json& json) {
  const auto* const bytes = std::get_if<std::uint64_t>(&json.plain());
  if (bytes == nullptr) throw Error("JSON: the value is no whole number from 0 on");
  return *bytes;
}

}  // namespace

Json to_json(const std::vector<InputFile>& inputs) {
  Json list = Json::array();
  for (const InputFile& input : inputs) {
    list.push_back({{"role", input.role},
                    {"file", input.file},
                    {"bytes", input.identity.bytes},
                    {"fnv1a64", input.identity.fnv1a64}});
  }
  return list;
}

Json to_json(const std::vector<OutputFile>& outputs) {
  Json list = Json::array();
  for (const OutputFile& output : outputs) {
    list.push_back({{"file", output.file}, {"bytes", output.bytes ? Json(*output.bytes) : Json()}});
  }
  return list;
}

Json reused_json(const std::string& folder, const std::vector<std::string>& results) {
  return {{"from", folder}, {"results", results}};
}

Json versions_json() {
  return {{"xgm", XGM_VERSION},
          {"opencv", CV_VERSION},
          {"compiler", __VERSION__},
          {"build", XGM_BUILD_TAG}};
}

Json to_json(const std::vector<StageRecord>& stages) {
  Json list = Json::array();
  for (const StageRecord& stage : stages) {
    const StagePlace& place = stage.place;
    Json entry = {{"stage", place.path},
                  {"kind", place.kind},
                  {"plugin", place.plugin},
                  {"depth", place.depth},
                  {"view", to_string(place.view)}};
    if (!place.level.name.empty()) {
      entry["level"] = {
          {"name", place.level.name}, {"scale", place.level.scale}, {"path", place.level.path}};
    }
    if (stage.finished) {
      entry["seconds"] = stage.statistics.seconds;
      entry["bytes"] = stage.statistics.bytes;
    }
    if (!stage.same_as.empty()) entry["same_as"] = stage.same_as;
    for (const auto& [name, value] : stage.figures) entry["figures"][name] = value;
    list.push_back(std::move(entry));
  }
  return list;
}

Json to_json(const std::vector<Override>& overrides) {
  Json list = Json::array();
  for (const Override& change : overrides) {
    list.push_back({{"path", change.path}, {"value", change.value}});
  }
  return list;
}

std::vector<InputFile> recorded_inputs(const std::string& run_json) {
  std::vector<InputFile> inputs;
  try {
    const Json record = Json::parse(run_json);
    for (const Json& input : record.at("scene").at("inputs")) {
      inputs.push_back(
          {input.at("role").text(),
           input.at("file").text(),
           {.bytes = to_bytes(input.at("bytes")), .fnv1a64 = input.at("fnv1a64").text()}});
    }
  } catch (const Error&) {
    return {};
  }
  return inputs;
}

std::vector<OutputFile> recorded_outputs(const std::string& run_json) {
  std::vector<OutputFile> outputs;
  try {
    const Json record = Json::parse(run_json);
    const Json* const list = record.find("outputs");
    if (list == nullptr) return {};
    for (const Json& output : *list) {
      if (!stays_in_folder(output.at("file").text())) continue;
      OutputFile& added = outputs.emplace_back(OutputFile{output.at("file").text(), {}});
      const Json& bytes = output.at("bytes");
      if (!bytes.is_null()) added.bytes = to_bytes(bytes);
    }
  } catch (const Error&) {
    return {};
  }
  return outputs;
}

}  // namespace xgm
