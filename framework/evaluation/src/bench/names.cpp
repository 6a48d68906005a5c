// SPDX-License-Identifier: Apache-2.0
// Names of pipelines and sets of scenes: unique, and fit for folders.
#include "bench/names.hpp"

#include <algorithm>
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

std::string fingerprint(const std::string& text) { return std::to_string(fnv1a64(text) % 1000000); }

fs::path plain(const fs::path& path) {
  std::error_code ignored;
  const fs::path folder = fs::weakly_canonical(path, ignored);
  return folder.has_filename() ? folder : folder.parent_path();
}

/// Whether the data folder holds the images of this scene, and of no other left view.
bool is_scene_folder(const BenchScene& scene, const std::vector<BenchScene>& all) {
  const std::string& left = scene.files.images.left;
  return plain(fs::path(left).parent_path()) == plain(scene.data_folder) &&
         std::all_of(all.begin(), all.end(), [&](const BenchScene& other) {
           return other.data_folder != scene.data_folder || other.files.images.left == left;
         });
}

/// Names that differ stay different, whatever other scenes there are: results are found again by
/// it.
std::string scene_folder_name(const std::string& scene) {
  const std::string name = folder_name(scene);
  return name == scene ? name : name + "-" + fingerprint(scene);
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
  if (name.size() > kLongest) name = name.substr(0, kLongest) + "-" + fingerprint(text);
  return name.find_first_not_of('.') == std::string::npos ? "_" + name : name;
}

void name_sets(std::vector<BenchScene>& scenes) {
  std::map<fs::path, std::string> names;
  std::set<std::string> taken;
  for (BenchScene& scene : scenes) {
    fs::path folder = plain(scene.data_folder);
    if (is_scene_folder(scene, scenes)) folder = folder.parent_path();
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

std::string cell_folder(const BenchRequest& request, std::size_t pipeline, std::size_t scene) {
  const BenchScene& where = request.scenes[scene];
  return (fs::path(request.output) / request.pipelines[pipeline].name / where.set /
          scene_folder_name(where.files.name))
      .string();
}

}  // namespace xgm
