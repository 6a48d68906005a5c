// SPDX-License-Identifier: Apache-2.0
// What lies in a folder, read once: layouts are recognised by names.
#pragma once

#include <set>
#include <string>

namespace xgm::dataset {

class Listing {
 public:
  /// Throws Error if there is no such folder or it cannot be read.
  explicit Listing(const std::string& folder);

  const std::string& path() const { return path_; }
  /// Path of the file of this name; empty if there is none. If no name is quite the same, one that
  /// differs in the case of its letters is taken, unless there are several. Likewise a folder's.
  std::string file(const std::string& name) const;
  std::string folder(const std::string& name) const;
  /// Path of the image called `stem` with the ending of any format that is read; empty if there is
  /// none.
  std::string image(const std::string& stem) const;
  /// Names, sorted; hidden ones left out. Links that lead nowhere are among the files.
  const std::set<std::string>& files() const { return files_; }
  const std::set<std::string>& folders() const { return folders_; }
  const std::set<std::string>& dangling() const { return dangling_; }

 private:
  std::string path_;
  std::set<std::string> files_, folders_, dangling_;
};

/// The image called `stem`, or where it would be: an image that is missing has a name, too.
std::string image_or(const Listing& folder, const std::string& stem, const char* ending);

/// Whether `name` has an ending of an image that is read.
bool is_image(const std::string& name);

/// The last part of a path, whatever way it was written: "." and "a/b/" have one too.
std::string name_of(const std::string& folder);
/// The folder that holds it.
std::string parent_of(const std::string& folder);

}  // namespace xgm::dataset
