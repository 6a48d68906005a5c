// SPDX-License-Identifier: Apache-2.0
#include "output_folder.hpp"

#include <filesystem>

#include "common.hpp"
#include "xgm/io/file.hpp"

namespace xgm::cli {
namespace fs = std::filesystem;

void make_output_folder(const std::string& option, const std::string& folder) {
  std::error_code failure, unusable;
  fs::create_directories(folder, failure);
  if (!fs::is_directory(folder, unusable)) {
    throw UsageError(option + folder + ": cannot be made a folder: " +
                     (failure ? failure.message() : "it is a file") + "; choose another one");
  }
  require_writable(option, folder);
}

void require_writable(const std::string& option, const std::string& folder) {
  const std::string trial = (fs::path(folder) / ".writable").string();
  try {
    write_file(trial, "");
  } catch (const Error& error) {
    throw UsageError(option + error.message());
  }
  std::error_code ignored;
  fs::remove(trial, ignored);
}

}  // namespace xgm::cli
