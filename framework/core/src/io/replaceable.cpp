// SPDX-License-Identifier: Apache-2.0
#include "io/replaceable.hpp"

#include <filesystem>

namespace xgm {

std::string objection_to_replacing(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code unusable;
  const fs::file_status status = fs::status(file, unusable);
  if (fs::is_directory(status)) return "it is a folder; give the name of a file";
  if (!fs::exists(status) || fs::is_regular_file(status)) return {};
  return "it is a device or a pipe; give the name of a file";
}

}  // namespace xgm
