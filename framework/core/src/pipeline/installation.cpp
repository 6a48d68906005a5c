// SPDX-License-Identifier: Apache-2.0
#include "xgm/pipeline/installation.hpp"

#include <filesystem>

#include "base/loaded_from.hpp"
#include "xgm/base/shipped_files.hpp"

namespace xgm {
namespace fs = std::filesystem;

std::string file_of(const void* function) { return loaded_from(function); }

std::string library_file() { return file_of(reinterpret_cast<const void*>(&loaded_from)); }

std::string pipelines_folder() { return shipped_folder(); }

std::string plugins_folder() {
  const fs::path folder = fs::path(library_file()).parent_path() / "xgm/plugins";
  std::error_code unusable;
  return fs::is_directory(folder, unusable) ? folder.string() : "";
}

}  // namespace xgm
