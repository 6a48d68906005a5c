// SPDX-License-Identifier: Apache-2.0
#include "base/loaded_from.hpp"

#include <dlfcn.h>

#include <filesystem>

namespace xgm {
namespace fs = std::filesystem;

std::string loaded_from(const void* function) {
  Dl_info info{};
  const bool found = ::dladdr(function, &info) != 0;
  if (!found || info.dli_fname == nullptr) return {};
  std::error_code unusable;
  const fs::path file = fs::canonical(info.dli_fname, unusable);
  return unusable ? std::string(info.dli_fname) : file.string();
}

}  // namespace xgm
