// SPDX-License-Identifier: Apache-2.0
// What there is under a name. A name that no file can have, because it is too long, is that of
// none.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace xgm::geo {

inline bool is_there(const std::string& path) {
  std::error_code unusable;
  return std::filesystem::exists(path, unusable);
}

inline bool is_folder(const std::string& path) {
  std::error_code unusable;
  return std::filesystem::is_directory(path, unusable);
}

}  // namespace xgm::geo
