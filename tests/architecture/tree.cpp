// SPDX-License-Identifier: Apache-2.0
#include "architecture/tree.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace xgm::architecture {
namespace {

bool is_source(const std::filesystem::path& path) {
  static const std::set<std::string> endings{".hpp", ".h", ".cpp", ".cmake", ".js", ".css", ".py"};
  return endings.contains(path.extension().string()) || path.filename() == "CMakeLists.txt";
}

}  // namespace

Tree read_tree(const std::string& top) {
  namespace fs = std::filesystem;
  Tree tree;
  for (const char* root : {"framework", "plugins", "apps", "tests"}) {
    if (!fs::exists(fs::path(top) / root)) continue;
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(top) / root)) {
      if (!entry.is_regular_file() || !is_source(entry.path())) continue;
      std::ifstream stream(entry.path(), std::ios::binary);
      std::ostringstream text;
      text << stream.rdbuf();
      tree[fs::relative(entry.path(), top).generic_string()] = text.str();
    }
  }
  return tree;
}

std::vector<std::string> split_path(std::string_view path) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    parts.emplace_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

bool has_folder(const Tree& tree, const std::string& folder) {
  const auto first = tree.lower_bound(folder + "/");
  return first != tree.end() && first->first.starts_with(folder + "/");
}

}  // namespace xgm::architecture
