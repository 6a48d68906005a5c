// SPDX-License-Identifier: Apache-2.0
#include "xgm/pipeline/question.hpp"

#include <link.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/core/version.hpp>
#include <set>

#include "xgm/pipeline/installation.hpp"

namespace xgm {
namespace {

int add_library(dl_phdr_info* loaded, std::size_t, void* files) {
  const std::filesystem::path file(loaded->dlpi_name);
  if (file.filename().string().starts_with("libxgm")) {
    static_cast<std::set<std::string>*>(files)->insert(file.string());
  }
  return 0;
}

/// Of all rooms: also those above the core decide, tiles of what each one looks at.
std::string program_hash() {
  std::set<std::string> files{library_file()};
  ::dl_iterate_phdr(add_library, &files);
  std::set<std::string> hashes;  // in an order of their own: libraries may lie anywhere
  for (const std::string& file : files) hashes.insert(identify_file(file).fnv1a64);
  std::string all = CV_VERSION;
  for (const std::string& hash : hashes) all += hash;
  return hash_text(all);
}

/// The files of a scene that a map is made of.
bool decides(const std::string& role) {
  static const std::set<std::string> roles{
      "left", "right", "left mask", "right mask", "smallest disparities", "largest disparities"};
  return roles.contains(role);
}

void add_differences(const Json& a, const Json& b, const std::string& path,
                     std::vector<std::string>& found) {
  const auto inner = [&](const std::string& key) { return path.empty() ? key : path + "." + key; };
  if (!a.is_object() || !b.is_object()) {
    if (a.dump() != b.dump()) found.push_back(path);
    return;
  }
  for (const auto& [key, value] : a.members()) {
    const Json* const other = b.find(key);
    add_differences(value, other != nullptr ? *other : Json(), inner(key), found);
  }
  for (const auto& [key, value] : b.members()) {
    if (!a.contains(key)) found.push_back(inner(key));
  }
}

std::string hash_of(const DisparityRange& ranges) {
  std::string bytes;
  bytes.reserve(ranges.bytes());
  for (int y = 0; y < ranges.size().height; ++y) {
    for (int x = 0; x < ranges.size().width; ++x) {
      const Interval at = ranges.at(y, x);
      bytes.append(reinterpret_cast<const char*>(&at), sizeof at);
    }
  }
  return hash_text(bytes);
}

template <class Value>
std::string hash_of(const cv::Mat_<Value>& values) {
  const cv::Mat_<Value> whole = values.isContinuous() ? values : values.clone();
  return hash_text({reinterpret_cast<const char*>(whole.data), whole.total() * sizeof(Value)});
}

std::string hash_of(const Image& image) {
  std::string all = hash_of(image.valid);
  for (const cv::Mat1f& plane : image.planes) all += hash_of(plane);
  return all;
}

}  // namespace

std::string hash_of(const MatchRequest& request) {
  const cv::Size size = request.pair.size();
  std::string all = std::to_string(size.width) + "x" + std::to_string(size.height) +
                    (request.pair.is_reverse ? "r" : "");
  all += hash_of(request.pair.base) + hash_of(request.pair.match) + hash_of(request.range);
  if (request.reverse_range) all += hash_of(*request.reverse_range);
  return hash_text(all);
}

Json question_of(const Pipeline& pipeline, const std::vector<std::string>& plugin_files) {
  Json question = {{"program", program_hash()}};
  std::vector<std::string> plugins;
  for (const std::string& file : plugin_files) plugins.push_back(identify_file(file).fnv1a64);
  question["plugin files"] = Json(plugins);
  question["pipeline"] = Json::parse(pipeline.resolved_json());
  return question;
}

Json question_of(const Pipeline& pipeline, const SceneRequest& request, const SceneInputs& inputs,
                 const std::vector<std::string>& plugin_files) {
  Json question = question_of(pipeline, plugin_files);
  for (const InputFile& input : inputs.scene.inputs) {
    if (decides(input.role)) question[input.role] = input.identity.fnv1a64;
  }
  if (const auto* const files = std::get_if<SceneFiles>(&request.scene)) {
    question["no data of the images"] = Json(files->images.no_data);
  }
  if (request.range_maps) question["no data of the range maps"] = Json(request.range_maps->no_data);
  if (request.ranges) question["range maps"] = hash_of(*request.ranges);
  const Interval searched = inputs.range.hull();
  question["disparities"] = Json(std::vector<int>{searched.begin, searched.end - 1});
  return question;
}

Json question_of_matcher(Json question) {
  for (const char* after : {"postprocess", "disparities"}) question["pipeline"].erase(after);
  return question;
}

std::string difference(const Json& a, const Json& b) {
  std::vector<std::string> found;
  add_differences(a, b, "", found);
  std::string text;
  for (const std::string& name : found) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace xgm
