// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/output_folder.hpp"

#include <filesystem>

#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"

namespace xgm {
namespace fs = std::filesystem;

void make_output_folder(const std::string& folder, const std::string& what) {
  std::error_code failure, unusable;
  fs::create_directories(folder, failure);
  if (!fs::is_directory(folder, unusable)) {
    throw UsageError(what + folder + ": cannot be made a folder: " +
                     (failure ? failure.message() : "it is a file") + "; choose another one");
  }
  require_writable(folder, what);
}

void require_writable(const std::string& folder, const std::string& what) {
  const std::string trial = (fs::path(folder) / ".writable").string();
  try {
    write_file(trial, "");
  } catch (const Error& error) {
    throw UsageError(what + error.message());
  }
  std::error_code ignored;
  fs::remove(trial, ignored);
}

}  // namespace xgm
