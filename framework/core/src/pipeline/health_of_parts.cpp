// SPDX-License-Identifier: Apache-2.0
// Plugin files and shipped pipelines: what is there, and what does not work.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "xgm/base/suggest.hpp"
#include "xgm/pipeline/health.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm {
namespace {

namespace fs = std::filesystem;

Finding searched_places() {
  const char* const variable = std::getenv("XGM_PLUGIN_PATH");
  const std::string paths = variable != nullptr ? variable : "";
  const std::string folder = plugins_folder();
  return {.topic = "plugin path",
          .text = (paths.empty() ? "XGM_PLUGIN_PATH is not set" : "XGM_PLUGIN_PATH=" + paths) +
                  "; " +
                  (folder.empty() ? "there is no folder xgm/plugins beside the library"
                                  : "files in " + folder + " are loaded"),
          .facts = {{"XGM_PLUGIN_PATH", paths}, {"folder", folder}}};
}

Finding loaded_file(const std::string& file, const Registry& registry) {
  std::vector<std::string> stages;
  for (const PluginInfo* plugin : registry.plugins()) {
    if (plugin->origin == file) stages.push_back(plugin->kind + "/" + plugin->name);
  }
  return {.topic = "plugin file",
          .text = file + ": " + join(stages),
          .facts = {{"file", file}, {"stages", stages}}};
}

/// Every shipped pipeline, those of other families in folders of their own.
std::vector<std::string> pipeline_files(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code unusable;
  for (const auto& entry : fs::recursive_directory_iterator(folder, unusable)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Whether the mistakes are those of a part that is a finding of its own.
bool lacks_a_part(const Diagnostics& diagnostics, const Registry& registry) {
  return std::ranges::any_of(diagnostics, [&](const Diagnostic& diagnostic) {
    return std::ranges::any_of(registry.failures(), [&](const LoadFailure& failure) {
      return diagnostic.remedy.find(failure.reason) != std::string::npos;
    });
  });
}

}  // namespace

std::vector<Finding> examine_plugins(const Registry& registry) {
  std::vector<Finding> findings{searched_places()};
  for (const std::string& file : plugin_files(registry)) {
    findings.push_back(loaded_file(file, registry));
  }
  for (const LoadFailure& failure : registry.failures()) {
    findings.push_back({.topic = "plugin file",
                        .health = Health::broken,
                        .text = failure.file + ": " + failure.reason,
                        .facts = {{"file", failure.file}, {"reason", failure.reason}}});
  }
  return findings;
}

std::vector<Finding> examine_pipelines(const Registry& registry) {
  const std::string folder = pipelines_folder();
  const std::vector<std::string> files = pipeline_files(folder);
  if (files.empty()) {
    return {{.topic = "pipelines",
             .health = Health::broken,
             .text = "no shipped pipelines lie beside " + library_file() +
                     ", in share/xgm/pipelines of its prefix; install xgm again"}};
  }
  std::vector<Finding> findings;
  for (const std::string& file : files) {
    const Diagnostics diagnostics = load_pipeline(file, registry).diagnostics;
    if (diagnostics.empty()) continue;
    const bool left_out = lacks_a_part(diagnostics, registry);
    findings.push_back({.topic = "pipeline",
                        .health = left_out ? Health::missing : Health::broken,
                        .text = to_string(diagnostics.front()),
                        .facts = {{"file", file}}});
  }
  findings.insert(findings.begin(),
                  {.topic = "pipelines",
                   .text = std::to_string(files.size() - findings.size()) + " of " +
                           std::to_string(files.size()) + " in " + folder + " can be run",
                   .facts = {{"folder", folder},
                             {"pipelines", files.size()},
                             {"sound", files.size() - findings.size()}}});
  return findings;
}

}  // namespace xgm
