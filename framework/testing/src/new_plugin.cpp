// SPDX-License-Identifier: Apache-2.0
// Templates are whole plugins called my_plugin, of which copies get another name: so they are read,
// compiled and tested as what they are.
#include "xgm/testing/new_plugin.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "xgm/base/error.hpp"
#include "xgm/base/suggest.hpp"
#include "xgm/io/file.hpp"
#include "xgm/pipeline/installation.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm::testing {
namespace {

namespace fs = std::filesystem;

/// What plugins of all kinds have, and how their sources end.
struct Files {
  const char* common;
  const char* ending;
  const char* other_ending;
};
Files files_of(Language language) {
  return language == Language::cpp ? Files{"cpp", ".cpp", ".py"} : Files{"python", ".py", ".cpp"};
}

/// "MyPlugin" of "my_plugin"
std::string class_name(const std::string& name) {
  std::string text;
  bool capital = true;
  for (const char c : name) {
    if (c != '_') text += capital ? static_cast<char>(std::toupper(c)) : c;
    capital = c == '_';
  }
  return text;
}

void replace_all(std::string& text, const std::string& word, const std::string& by) {
  for (std::size_t at = text.find(word); at != std::string::npos;
       at = text.find(word, at + by.size())) {
    text.replace(at, word.size(), by);
  }
}

std::string renamed(std::string text, const NewPlugin& plugin) {
  replace_all(text, "my_plugin", plugin.name);
  replace_all(text, "MyPlugin", class_name(plugin.name));
  replace_all(text, "my_kind", plugin.kind);
  return text;
}

/// What is written with it is not ours.
std::string without_licence(const std::string& text) {
  const std::size_t end = text.find('\n') + 1;
  return text.substr(0, end).find("SPDX") == std::string::npos ? text : text.substr(end);
}

void require_sound_name(const std::string& name) {
  // Targets of CMake, and modules that the Python template imports.
  static constexpr std::array kReserved{
      "all",   "clean",   "edit_cache",    "help", "install", "list_install_components",
      "numpy", "package", "rebuild_cache", "test", "xgm"};
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  };
  if (name.empty() || name.front() < 'a' || name.front() > 'z' ||
      !std::ranges::all_of(name, is_allowed)) {
    throw UsageError("'" + name +
                     "' is no name of a plugin: write small letters, digits and _, a letter first, "
                     "for example my_cost");
  }
  if (std::ranges::find(kReserved, name) != kReserved.end()) {
    throw UsageError("'" + name + "' has another meaning to CMake or Python; choose another name");
  }
}

void require_template(const NewPlugin& plugin, const Registry& registry) {
  if (templates_folder().empty()) {
    throw UsageError("no templates of plugins lie beside " + library_file() +
                     ", in share/xgm/new_plugin of its prefix; install xgm's component testing");
  }
  require_kind(plugin.kind, registry);
  const std::vector<std::string> kinds = template_kinds(plugin.language);
  if (std::ranges::find(kinds, plugin.kind) != kinds.end()) return;
  const bool python = plugin.language == Language::python;
  throw UsageError("there is no template for kind '" + plugin.kind + "'" +
                   (python ? " in Python"
                           : "; begin with a copy of one of its plugins, in "
                             "plugins/" +
                                 plugin.kind + " of xgm's source tree") +
                   "; there are templates for " + join(kinds));
}

void require_new(const NewPlugin& plugin, const Registry& registry) {
  const PluginInfo* const taken = registry.find(plugin.kind, plugin.name);
  if (taken != nullptr) {
    const std::string origin = taken->origin.empty() ? "built in" : taken->origin;
    throw UsageError("there is a " + plugin.kind + " called '" + plugin.name + "' already (" +
                     origin + "); choose another name");
  }
  std::error_code unusable;
  if (fs::symlink_status(plugin.folder, unusable).type() != fs::file_type::not_found) {
    throw UsageError("--output " + plugin.folder +
                     ": is there already; remove it, or give another folder");
  }
  const fs::path parent = fs::absolute(plugin.folder).parent_path();
  if (!fs::is_directory(parent, unusable)) {
    throw UsageError("--output " + plugin.folder + ": there is no folder " + parent.string() +
                     " to make it in; make that first");
  }
}

void copy_templates(const fs::path& from, const fs::path& to, const NewPlugin& plugin) {
  for (const auto& entry : fs::directory_iterator(from)) {
    const fs::path& file = entry.path();
    if (file.extension() == files_of(plugin.language).other_ending) continue;
    write_file((to / renamed(file.filename().string(), plugin)).string(),
               without_licence(renamed(read_file(file.string()), plugin)));
  }
}

}  // namespace

std::string templates_folder() {
  const std::string pipelines = pipelines_folder();
  const fs::path folder = fs::path(pipelines).parent_path() / "new_plugin";
  std::error_code unusable;
  return !pipelines.empty() && fs::is_directory(folder, unusable) ? folder.string() : "";
}

std::vector<std::string> template_kinds(Language language) {
  const std::string source = std::string("my_plugin") + files_of(language).ending;
  std::vector<std::string> kinds;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(templates_folder(), missing)) {
    if (fs::exists(entry.path() / source)) kinds.push_back(entry.path().filename().string());
  }
  std::ranges::sort(kinds);
  return kinds;
}

void write_new_plugin(const NewPlugin& plugin, const Registry& registry) {
  require_sound_name(plugin.name);
  require_template(plugin, registry);
  require_new(plugin, registry);
  const fs::path templates = templates_folder();
  const fs::path folder = fs::absolute(plugin.folder).lexically_normal();
  fs::path unfinished = folder.has_filename() ? folder : folder.parent_path();
  unfinished += ".unfinished-" + std::to_string(::getpid());
  try {
    fs::create_directory(unfinished);
    copy_templates(templates / files_of(plugin.language).common, unfinished, plugin);
    copy_templates(templates / plugin.kind, unfinished, plugin);
    fs::rename(unfinished, folder);
  } catch (const std::exception& error) {
    std::error_code ignored;
    fs::remove_all(unfinished, ignored);
    throw Error("--output " + plugin.folder + ": cannot be written: " + error.what());
  }
}

}  // namespace xgm::testing
