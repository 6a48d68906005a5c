// SPDX-License-Identifier: Apache-2.0
#include "xgm/pipeline/lookup.hpp"

#include <algorithm>
#include <filesystem>

#include "plugin/unknown_plugin.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/suggest.hpp"

namespace xgm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kEnding = ".yaml";

/// The folder, and those in it: one for each other family of pipelines.
std::vector<fs::path> folders_of(const std::string& folder) {
  std::vector<fs::path> folders{folder};
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing)) {
    if (entry.is_directory(missing)) folders.push_back(entry.path());
  }
  std::sort(folders.begin() + 1, folders.end());
  return folders;
}

std::vector<std::string> all_names(const std::string& folder) {
  std::vector<std::string> names;
  for (const fs::path& below : folders_of(folder)) {
    const std::vector<std::string> found = shipped_pipelines(below.string());
    names.insert(names.end(), found.begin(), found.end());
  }
  return names;
}

/// "did you mean 'q.yaml'? " for q.yml, among the files beside it and the shipped; may be empty.
std::string guess(const std::string& name, const std::vector<std::string>& shipped) {
  const fs::path path(name);
  const std::string file = path.filename().string();
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const std::vector<std::string> beside = shipped_pipelines(folder.string());
  const std::string with_ending = file.ends_with(kEnding) ? file : file + kEnding;
  for (const std::string& text : {suggest(file, beside, ""), suggest(with_ending, beside, ""),
                                  suggest(with_ending, shipped, "")}) {
    if (text.starts_with("did you mean")) return text + " ";
  }
  return "";
}

bool is_path(const std::string& name) { return name.find('/') != std::string::npos; }

}  // namespace

std::vector<std::string> shipped_pipelines(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing)) {
    if (entry.path().extension() == kEnding) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string find_pipeline(const std::string& name, const std::string& folder) {
  std::error_code unusable;  // a name too long or a link to itself is no file, and no exception
  if (fs::is_directory(name, unusable)) {
    throw UsageError(name +
                     ": is a folder, not a pipeline file; the pipeline comes first, the scene "
                     "second");
  }
  if (fs::exists(name, unusable)) return name;
  if (!is_path(name) && !name.empty()) {
    for (const fs::path& below : folders_of(folder)) {
      for (const std::string& candidate : {name, name + kEnding}) {
        const fs::path file = below / candidate;
        if (file.extension() == kEnding && fs::is_regular_file(file, unusable))
          return file.string();
      }
    }
  }
  const std::vector<std::string> names = all_names(folder);
  throw UsageError("'" + name + "' is neither a file nor a shipped pipeline; " +
                   guess(name, names) +
                   (!names.empty()   ? "shipped are: " + join(names)
                    : folder.empty() ? "none are shipped beside " + library_file()
                                     : "none are shipped in " + folder));
}

Pipeline require_pipeline(const std::string& name, const Registry& registry,
                          const std::vector<Override>& overrides) {
  const LoadedPipeline loaded = load_pipeline(find_pipeline(name), registry, overrides);
  if (!loaded.pipeline) throw UsageError(to_string(loaded.diagnostics));
  return *loaded.pipeline;
}

std::vector<const PluginInfo*> find_plugins(const std::string& name, const Registry& registry) {
  const std::size_t slash = name.find('/');
  std::vector<const PluginInfo*> found;
  if (slash == std::string::npos) {
    found = registry.named(name);
  } else {
    require_kind(name.substr(0, slash), registry);
    const PluginInfo* plugin = registry.find(name.substr(0, slash), name.substr(slash + 1));
    if (plugin != nullptr) found.push_back(plugin);
  }
  if (!found.empty()) return found;
  for (const LoadFailure& failure : registry.failures()) {
    if (failure.name == name) {
      throw UsageError("plugin '" + name + "' could not be loaded from " + failure.file + ": " +
                       failure.reason);
    }
  }
  std::vector<std::string> names;
  for (const PluginInfo* plugin : registry.plugins()) {
    names.push_back(slash == std::string::npos ? plugin->name : plugin->kind + "/" + plugin->name);
  }
  throw UsageError("there is no plugin '" + name + "'; " +
                   unknown_plugin_remedy(name, names, "plugins"));
}

std::vector<std::string> plugin_files(const Registry& registry) {
  std::vector<std::string> files;
  for (const PluginInfo* plugin : registry.plugins()) {
    const bool known = std::find(files.begin(), files.end(), plugin->origin) != files.end();
    if (!plugin->origin.empty() && !known) files.push_back(plugin->origin);
  }
  return files;
}

void require_name(const std::string& what, const std::string& name,
                  const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw UsageError("there is no " + what + " '" + name + "'; " + suggest(name, names, what + "s"));
}

void require_kind(const std::string& kind, const Registry& registry) {
  std::vector<std::string> names;
  for (const KindInfo& known : registry.kinds()) names.push_back(known.name);
  require_name("kind", kind, names);
}

}  // namespace xgm
