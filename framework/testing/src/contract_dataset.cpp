// SPDX-License-Identifier: Apache-2.0
// The contract of data sets, tried on folders that are none of theirs.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "contract_support.hpp"
#include "xgm/base/error.hpp"

namespace xgm::testing {
namespace fs = std::filesystem;
namespace {

/// A folder of our own, gone at the end.
class Place {
 public:
  Place() : path_(fs::temp_directory_path() / ("xgm_contract_" + std::to_string(::getpid()))) {
    fs::create_directories(path_ / "empty");
    fs::create_directories(path_ / "other" / "inner");
    std::ofstream(path_ / "other" / "notes.txt") << "nothing to match\n";
    std::ofstream(path_ / "other" / "inner" / "photo.png") << "no pair\n";
  }
  ~Place() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  std::string operator/(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

bool is_error_that_names(const Dataset& stage, const std::string& path) {
  try {
    stage.scenes(path);
  } catch (const Error& error) {
    return error.message().find(path) != std::string::npos;
  }
  return false;
}

}  // namespace

Violations check_dataset(const Dataset& stage, const Watch& watch) {
  detail::Report report(watch);
  const Place place;
  for (const char* name : {"empty", "other"}) {
    report.with(name, [&] {
      report.expect(stage.scenes(place / name).empty(), "finds scenes where there are none");
    });
  }
  for (const char* name : {"missing", "other/notes.txt"}) {
    report.with(name, [&] {
      report.expect(is_error_that_names(stage, place / name),
                    "what is no folder is not an Error that names it");
    });
  }
  report.with("itself",
              [&] { report.expect(!stage.layout().empty(), "does not say what it looks for"); });
  return report.take();
}

}  // namespace xgm::testing
