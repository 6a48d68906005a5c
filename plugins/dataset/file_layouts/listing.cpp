// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/file_layouts/listing.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "xgm/base/error.hpp"
#include "xgm/base/file_names.hpp"

namespace xgm::dataset {
namespace fs = std::filesystem;
namespace {

// The one that comes first is taken if a folder has several.
constexpr std::array kEndings = {".png",  ".ppm", ".pgm",  ".pfm", ".tif",
                                 ".tiff", ".jpg", ".jpeg", ".bmp"};

fs::path absolute(const std::string& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();  // "a/b/" ends in an empty name
}

}  // namespace

Listing::Listing(const std::string& folder) : path_(folder) {
  std::error_code failure;
  const fs::file_status status = fs::status(folder, failure);
  if (!fs::exists(status)) throw Error(folder + ": no such folder; check the path");
  if (!fs::is_directory(status)) throw Error(folder + ": is a file; give a folder");
  for (fs::directory_iterator i(folder, failure), end; !failure && i != end; i.increment(failure)) {
    const std::string name = i->path().filename().string();
    if (name.starts_with('.')) continue;
    std::error_code unusable;
    const bool leads_nowhere = i->is_symlink(unusable) && !i->exists(unusable);
    if (i->is_directory(unusable)) folders_.insert(name);
    if (i->is_regular_file(unusable) || leads_nowhere) files_.insert(name);
    if (leads_nowhere) dangling_.insert(name);
  }
  if (failure) {
    throw Error(folder + ": cannot be read: " + failure.message() + "; check the permissions");
  }
}

std::string Listing::file(const std::string& name) const {
  const std::string found = find_name(files_, name);
  return found.empty() ? "" : (fs::path(path_) / found).string();
}

std::string Listing::folder(const std::string& name) const {
  const std::string found = find_name(folders_, name);
  return found.empty() ? "" : (fs::path(path_) / found).string();
}

std::string Listing::image(const std::string& stem) const {
  for (const char* ending : kEndings) {
    if (files_.contains(stem + ending)) return file(stem + ending);
  }
  for (const char* ending : kEndings) {
    if (const std::string found = file(stem + ending); !found.empty()) return found;
  }
  return {};
}

std::string image_or(const Listing& folder, const std::string& stem, const char* ending) {
  const std::string file = folder.image(stem);
  return file.empty() ? (fs::path(folder.path()) / (stem + ending)).string() : file;
}

bool is_image(const std::string& name) {
  const std::string lower = lower_case(name);
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&](const char* ending) { return lower.ends_with(ending); });
}

std::string name_of(const std::string& folder) { return absolute(folder).filename().string(); }
std::string parent_of(const std::string& folder) { return absolute(folder).parent_path().string(); }

}  // namespace xgm::dataset
