// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/folder/pattern.hpp"

#include <filesystem>
#include <optional>

#include "plugins/dataset/file_layouts/listing.hpp"
#include "xgm/base/file_names.hpp"

namespace xgm::folder {
namespace fs = std::filesystem;
namespace {

const std::string kGap = "{scene}";

std::string replace_gaps(std::string text, const std::string& scene) {
  for (std::size_t i = text.find(kGap); i != std::string::npos; i = text.find(kGap, i)) {
    text.replace(i, kGap.size(), scene);
    i += scene.size();
  }
  return text;
}

/// The name that makes `part`, which has a gap, equal to `name`.
std::optional<std::string> match(const std::string& part, const std::string& name) {
  const std::size_t begin = part.find(kGap);
  if (begin >= name.size()) return std::nullopt;
  for (std::size_t length = name.size() - begin; length > 0; --length) {
    const std::string scene = name.substr(begin, length);
    if (lower_case(replace_gaps(part, scene)) == lower_case(name)) return scene;
  }
  return std::nullopt;
}

}  // namespace

bool has_gap(const std::string& pattern) { return pattern.find(kGap) != std::string::npos; }

bool has_unknown_placeholder(const std::string& pattern) {
  constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ_abcdefghijklmnopqrstuvwxyz";
  const std::string text = replace_gaps(pattern, "");
  for (std::size_t i = text.find('{'); i != std::string::npos; i = text.find('{', i + 1)) {
    const std::size_t end = text.find_first_not_of(kLetters, i + 1);
    if (end != std::string::npos && text[end] == '}') return true;
  }
  return false;
}

std::string fill(const std::string& pattern, const std::string& scene, const std::string& top) {
  if (pattern.empty()) return {};
  return (fs::path(top) / replace_gaps(pattern, scene)).lexically_normal().string();
}

std::set<std::string> names_that_fit(const std::string& pattern, const std::string& top) {
  fs::path before(top);
  const fs::path path(pattern);
  for (auto part = path.begin(); part != path.end(); ++part) {
    if (!has_gap(part->string())) {
      before = find_path((before / *part).string());
      continue;
    }
    std::error_code unusable;
    if (!fs::is_directory(before, unusable)) return {};
    const dataset::Listing listing(before.string());
    std::set<std::string> names;
    const bool is_last = std::next(part) == path.end();
    for (const std::string& name : is_last ? listing.files() : listing.folders()) {
      if (const auto scene = match(part->string(), name)) names.insert(*scene);
    }
    return names;
  }
  return {};
}

}  // namespace xgm::folder
