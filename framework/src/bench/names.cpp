// SPDX-License-Identifier: Apache-2.0
// Names of pipelines and sets of scenes: unique, and fit for folders.
#include "bench/names.hpp"

#include <filesystem>
#include <map>
#include <set>

namespace xgm {
namespace fs = std::filesystem;
namespace {

/// `name`, or `name`-2, -3, ... if it is taken.
std::string unique(const std::string& name, std::set<std::string>& taken) {
  std::string result = name;
  for (int i = 2; !taken.insert(result).second; ++i) result = name + "-" + std::to_string(i);
  return result;
}

/// The folder that gives its name to the set of a scene.
fs::path set_folder(const BenchScene& scene) {
  std::error_code ignored;
  fs::path folder = fs::weakly_canonical(scene.data_folder, ignored);
  if (folder.filename().empty()) folder = folder.parent_path();
  // A folder that is a scene itself: its neighbours may be given, too.
  return folder.filename() == scene.files.name ? folder.parent_path() : folder;
}

}  // namespace

std::string folder_name(const std::string& text) {
  static const std::string harmless = "._-+=,";
  std::string name;
  for (const char c : text) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    const bool other = (static_cast<unsigned char>(c) & 0x80) != 0;  // part of a UTF-8 letter
    name += letter || other || harmless.find(c) != std::string::npos ? c : '_';
  }
  constexpr std::size_t kLongest = 120;  // file systems end at 255
  if (name.size() > kLongest) {
    name = name.substr(0, kLongest) + "-" + std::to_string(fnv1a64(text) % 1000000);
  }
  return name.find_first_not_of('.') == std::string::npos ? "_" + name : name;
}

void name_sets(std::vector<BenchScene>& scenes) {
  std::map<fs::path, std::string> names;
  std::set<std::string> taken;
  for (BenchScene& scene : scenes) {
    const fs::path folder = set_folder(scene);
    if (!names.contains(folder)) {
      names[folder] = unique(folder_name(folder.filename().string()), taken);
    }
    scene.set = names[folder];
  }
}

void name_folders(std::vector<BenchPipeline>& pipelines) {
  std::set<std::string> taken{"submit"};  // beside the cells
  for (BenchPipeline& pipeline : pipelines) {
    pipeline.name = unique(folder_name(pipeline.name), taken);
  }
}

std::string cell_folder(const BenchPlan& plan, std::size_t pipeline, std::size_t scene) {
  const BenchScene& where = plan.scenes[scene];
  return (fs::path(plan.output) / plan.pipelines[pipeline].name / where.set /
          folder_name(where.files.name))
      .string();
}

}  // namespace xgm
