// SPDX-License-Identifier: Apache-2.0
#include "xgm/pipeline/installation.hpp"

#include <dlfcn.h>

#include <filesystem>

namespace xgm {
namespace fs = std::filesystem;
namespace {

std::string if_folder(const fs::path& path) {
  std::error_code unusable;
  return fs::is_directory(path, unusable) ? path.string() : "";
}

}  // namespace

std::string file_of(const void* function) {
  Dl_info info{};
  const bool found = ::dladdr(function, &info) != 0;
  if (!found || info.dli_fname == nullptr) return {};
  std::error_code unusable;
  const fs::path file = fs::canonical(info.dli_fname, unusable);
  return unusable ? std::string(info.dli_fname) : file.string();
}

std::string library_file() { return file_of(reinterpret_cast<const void*>(&if_folder)); }

std::string pipelines_folder() {
  // PREFIX/lib, PREFIX/lib/x86_64-linux-gnu, PREFIX/bin of a program that the library is part of.
  const fs::path libraries = fs::path(library_file()).parent_path();
  for (const fs::path& prefix : {libraries.parent_path(), libraries.parent_path().parent_path()}) {
    const std::string folder = if_folder(prefix / "share/xgm/pipelines");
    if (!folder.empty()) return folder;
  }
  return {};
}

std::string plugins_folder() {
  return if_folder(fs::path(library_file()).parent_path() / "xgm/plugins");
}

}  // namespace xgm
