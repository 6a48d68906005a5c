// SPDX-License-Identifier: Apache-2.0
#include "architecture/rules.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

namespace xgm::architecture {
namespace {

struct Include {
  std::string target;
  bool quoted = false;
};

bool starts_with_any(const std::string& text, const std::vector<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& beginning) { return text.starts_with(beginning); });
}

std::vector<Include> includes(const std::string& text) {
  static const std::regex directive(R"(^\s*#\s*include\s*(["<])([^">]+)[">])");
  std::vector<Include> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, directive)) found.push_back({match[2], match[1] == "\""});
  }
  return found;
}

/// Level of a header ("xgm/..."). It may include those of lower levels and those of its own group.
struct Layer {
  std::string beginning;
  int level;
  std::string group;
};

const Layer* layer_of(const std::string& header) {
  static const std::vector<Layer> layers{{"xgm/base/", 0, "base"},
                                         {"xgm/data/", 1, "data"},
                                         {"xgm/config/", 1, "config"},
                                         {"xgm/stage/", 2, "stage"},
                                         {"xgm/plugin.hpp", 3, "plugin"},
                                         {"xgm/plugin/", 3, "plugin"},
                                         {"xgm/io/", 4, "facade"},
                                         {"xgm/pipeline/pipeline.hpp", 4, "facade"},
                                         {"xgm/pipeline/lookup.hpp", 4, "facade"},
                                         {"xgm/base/memory.hpp", 4, "facade"},
                                         {"xgm/bench", 4, "facade"},
                                         {"xgm/evaluation/report.hpp", 4, "facade"},
                                         {"xgm/evaluation/explain.hpp", 4, "facade"},
                                         {"xgm/synthesis/generate.hpp", 4, "facade"},
                                         {"xgm/evaluation/metrics.hpp", 4, "facade"},
                                         {"xgm/evaluation/sparsification.hpp", 4, "facade"},
                                         {"xgm/evaluation/evaluation_report.hpp", 4, "facade"},
                                         {"xgm/evaluation/run_record.hpp", 4, "facade"},
                                         {"xgm/pipeline/plan.hpp", 4, "facade"},
                                         {"xgm/testing/", 5, "testing"}};
  for (const Layer& layer : layers)
    if (header.starts_with(layer.beginning)) return &layer;
  return nullptr;
}

bool is_inner_library(const std::string& header) {
  return starts_with_any(header, {"yaml-cpp/", "spdlog/", "CLI/", "CLI11", "nlohmann/"});
}

using Complaint = std::optional<std::string>;

Complaint judge_sdk(const std::string& file, const Include& include) {
  if (is_inner_library(include.target)) return "an SDK header shows a library that stays inside";
  if (!include.quoted) return {};
  const Layer* from = layer_of(file.substr(std::string("framework/include/").size()));
  const Layer* to = layer_of(include.target);
  if (from == nullptr) return "this folder has no place in the layers; add it to the rules";
  if (to == nullptr) return "an SDK header may include SDK headers only";
  if (to->group == from->group || to->level < from->level) return {};
  return "the layer " + from->group + " does not lie above " + to->group;
}

/// "plugins/<kind>/<name>/" of a file in it.
std::string plugin_folder(const std::string& file) {
  std::size_t end = 0;
  for (int i = 0; i < 3; ++i) end = std::min(file.find('/', end), file.size() - 1) + 1;
  return file.substr(0, end);
}

Complaint judge_plugin(const std::string& file, const Include& include) {
  if (is_inner_library(include.target)) return "a plugin uses a library that stays inside";
  if (!include.quoted) return {};
  const std::string folder = plugin_folder(file);
  const std::string kind = folder.substr(0, folder.find('/', std::string("plugins/").size()) + 1);
  if (starts_with_any(include.target, {folder, kind + "shared/"})) return {};
  if (include.target.starts_with("plugins/")) return "a plugin may not include another's folder";
  const Layer* layer = layer_of(include.target);
  if (layer == nullptr) return "a plugin may include the SDK and its own files by full path only";
  if (layer->level > 3) return "this header is for applications and tests";
  return {};
}

Complaint judge_framework(const Include& include) {
  if (starts_with_any(include.target, {"plugins/", "apps/"}))
    return "the framework knows no plugin and no application";
  return {};
}

Complaint judge_app(const std::string& file, const Include& include, const Tree& tree) {
  if (!include.quoted) return {};
  const Layer* layer = layer_of(include.target);
  if (layer != nullptr && layer->group == "facade") return {};
  static const std::vector<std::string> open{"xgm/data/",
                                             "xgm/base/",
                                             "xgm/config/diagnostics.hpp",
                                             "xgm/plugin/registry.hpp",
                                             "xgm/plugin/version.hpp",
                                             "xgm/stage/context.hpp",
                                             "xgm/synthesis/plain_scene.hpp"};
  if (starts_with_any(include.target, open)) return {};
  const std::string folder = file.substr(0, file.rfind('/') + 1);
  if (include.target.find("..") == std::string::npos &&
      (tree.contains(folder + include.target) || include.target.starts_with(folder)))
    return {};
  return "an application may use the facade, the data it handles, and its own files only";
}

Complaint judge(const std::string& file, const Include& include, const Tree& tree) {
  if (file.starts_with("framework/include/")) return judge_sdk(file, include);
  if (file.starts_with("framework/")) return judge_framework(include);
  if (file.starts_with("plugins/")) return judge_plugin(file, include);
  if (file.starts_with("apps/")) return judge_app(file, include, tree);
  return {};
}

/// The file of the tree that is meant, or "".
std::string resolve(const std::string& file, const std::string& target, const Tree& tree) {
  const std::string beside = file.substr(0, file.rfind('/') + 1);
  for (const std::string& root :
       {beside, std::string("framework/include/"), std::string("framework/src/"),
        std::string("tests/"), std::string()}) {
    const std::string path = std::filesystem::path(root + target).lexically_normal().string();
    if (tree.contains(path)) return path;
  }
  return {};
}

/// Depth-first walk; a file met again while it is still open closes a cycle.
class CycleFinder {
 public:
  explicit CycleFinder(const Tree& tree) : tree_(tree) {}

  Faults run() {
    for (const auto& [file, text] : tree_) visit(file);
    return faults_;
  }

 private:
  void visit(const std::string& file) {
    const auto open = std::find(open_.begin(), open_.end(), file);
    if (open != open_.end()) {
      std::string chain;
      for (auto i = open; i != open_.end(); ++i) chain += *i + " -> ";
      faults_.push_back("include cycle: " + chain + file);
    }
    if (!seen_.insert(file).second) return;
    open_.push_back(file);
    for (const Include& include : includes(tree_.at(file))) {
      const std::string target = resolve(file, include.target, tree_);
      if (!target.empty()) visit(target);
    }
    open_.pop_back();
  }

  const Tree& tree_;
  std::vector<std::string> open_;
  std::set<std::string> seen_;
  Faults faults_;
};

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

Faults forbidden_includes(const Tree& tree) {
  Faults faults;
  for (const auto& [file, text] : tree)
    for (const Include& include : includes(text))
      if (const Complaint complaint = judge(file, include, tree))
        faults.push_back(file + " includes " + include.target + ": " + *complaint);
  return faults;
}

Faults include_cycles(const Tree& tree) { return CycleFinder(tree).run(); }

Faults missing_licences(const Tree& tree) {
  Faults faults;
  for (const auto& [file, text] : tree)
    if (!starts_with_any(text, {"// SPDX-License-Identifier: Apache-2.0\n",
                                "/* SPDX-License-Identifier: Apache-2.0 */\n",
                                "# SPDX-License-Identifier: Apache-2.0\n"}))
      faults.push_back(file + " does not begin with the SPDX line");
  return faults;
}

Faults long_files(const Tree& tree) {
  constexpr auto kMax = 500;
  Faults faults;
  for (const auto& [file, text] : tree) {
    const auto lines = std::count(text.begin(), text.end(), '\n');
    if (lines > kMax) faults.push_back(file + " has " + std::to_string(lines) + " lines");
  }
  return faults;
}

}  // namespace xgm::architecture
