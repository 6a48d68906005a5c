// SPDX-License-Identifier: Apache-2.0
#include "xgm/base/shipped_files.hpp"

#include <filesystem>

#include "base/loaded_from.hpp"

namespace xgm {
namespace fs = std::filesystem;

std::string shipped_folder() {
  // PREFIX/lib, PREFIX/lib/x86_64-linux-gnu, PREFIX/bin of a program that the library is part of.
  const fs::path library = loaded_from(reinterpret_cast<const void*>(&loaded_from));
  const fs::path libraries = library.parent_path();
  std::error_code unusable;
  for (const fs::path& prefix : {libraries.parent_path(), libraries.parent_path().parent_path()}) {
    const fs::path folder = prefix / "share/xgm/pipelines";
    if (fs::is_directory(folder, unusable)) return folder.string();
  }
  return {};
}

std::string find_shipped(const std::string& path) {
  std::error_code unusable;
  if (path.empty() || fs::exists(path, unusable)) return path;
  const fs::path shipped = fs::path(shipped_folder()) / path;
  return fs::is_regular_file(shipped, unusable) ? shipped.string() : path;
}

}  // namespace xgm
