// SPDX-License-Identifier: Apache-2.0
#include "record/files_json.hpp"

#include <filesystem>

#include "xgm/base/error.hpp"

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
