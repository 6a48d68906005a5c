// SPDX-License-Identifier: Apache-2.0
#include "options/output_files.hpp"

#include <filesystem>
#include <iostream>

#include "xgm/io/file.hpp"
#include "xgm/io/output_folder.hpp"

namespace xgm::cli {

namespace {

bool is_file(const NamedFile& output) {
  return !output.file.empty() && output.file != kStandardOutput;
}

}  // namespace

void require_outputs_apart(const std::vector<NamedFile>& inputs, std::vector<NamedFile> outputs) {
  std::erase_if(outputs, [](const NamedFile& output) { return !is_file(output); });
  require_apart(inputs, outputs);
}

void require_writable_output(const NamedFile& output) {
  if (!is_file(output)) return;
  require_writable(std::filesystem::path(output.file).parent_path().string(), output.role + " ");
}

void write_output(const std::string& file, const std::string& text) {
  if (file == kStandardOutput) {
    std::cout << text;
  } else if (!file.empty()) {
    write_file(file, text);
  }
}

}  // namespace xgm::cli
