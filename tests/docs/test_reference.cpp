// SPDX-License-Identifier: Apache-2.0
// The pages in docs/reference are what the plugins say of themselves. `make reference` writes them.
#include <doctest/doctest.h>

#include <filesystem>
#include <iostream>
#include <map>
#include <set>

#include "docs/blocks.hpp"
#include "support/paths.hpp"
#include "support/support.hpp"
#include "xgm/io/file.hpp"
#include "xgm/pipeline/describe.hpp"
#ifdef XGM_HAS_ALL_PLUGINS
#include "xgm/geo/registry.hpp"
#endif

using namespace xgm;
using namespace xgm::testing;

namespace {

const std::filesystem::path kFolder = std::filesystem::path(XGM_SOURCE_DIR) / "docs/reference";

constexpr const char* kNote = "<!-- Generated from the plugins by `make reference`. -->\n";

// Pages of the kinds that the room geo registers, and those on which its plugins appear.
const std::set<std::string> kPagesOfGeo{
    "README.md",   "filter.md",      "fusion.md",        "pairs.md",   "pipeline.md",
    "pointing.md", "range_prior.md", "rectification.md", "surface.md", "triangulation.md"};

// Those of all rooms, as far as they have been built.
const Registry& all_plugins() {
  static const Registry registry = [] {
    Registry all = Registry::with_builtins();
#ifdef XGM_HAS_ALL_PLUGINS
    geo::add_geo(all);
#endif
    return all;
  }();
  return registry;
}

// Whether what a page says is known here; if not, says so.
bool is_known(const std::string& page) {
#ifdef XGM_HAS_ALL_PLUGINS
  return !page.empty();
#else
  if (!kPagesOfGeo.contains(page)) return true;
  std::cout << "SKIPPED: docs/reference/" << page << " needs GDAL, PROJ and Ceres" << std::endl;
  return false;
#endif
}

std::string kind_of(const Field& field) {
  if (const auto* slot = std::get_if<SlotBase*>(&field.target)) {
    return std::string((*slot)->kind());
  }
  if (const auto* slots = std::get_if<SlotListBase*>(&field.target)) {
    return std::string((*slots)->kind());
  }
  return {};
}

std::string place_of(const Field& field, const PluginInfo& plugin) {
  const std::string text = "`" + field.name + "` of ";
  if (plugin.kind != PipelineFamily::kKind) return text + "`" + plugin.name + "`";
  const bool plain = plugin.name == PipelineFamily::kDefault;
  return text + (plain ? "the file" : "a file of type `" + plugin.name + "`");
}

// Where in a pipeline a stage of this kind may stand.
std::string places(const Registry& registry, const std::string& kind) {
  std::string text;
  for (const PluginInfo* plugin : registry.plugins()) {
    const auto prototype = plugin->prototype();
    for (const Field& field : prototype->parameters().fields()) {
      if (kind_of(field) != kind) continue;
      text += (text.empty() ? "" : ", ") + place_of(field, *plugin);
    }
  }
  return text;
}

// The header of a kind, which has its name, in the room that registers it.
std::string header_of(const std::string& kind) {
  for (const std::string room : {"core/include/xgm/stage/", "geo/include/xgm/geo/stage/"}) {
    const std::string path = "framework/" + room + kind + ".hpp";
    if (!std::filesystem::exists(std::filesystem::path(XGM_SOURCE_DIR) / path)) continue;
    return "[`" + path.substr(path.find("xgm/")) + "`](../../" + path + ")";
  }
  FAIL("kind ", kind, " has no header of its name");
  return {};
}

std::string page(const Registry& registry, const std::string& kind, const std::string& text) {
  const std::string article = kind.front() == 'a' ? "An " : "A ";
  std::string page = kNote + ("\n# Kind `" + kind + "`\n\n");
  if (kind == Dataset::kKind) {
    page += "A data set " + text + ".\n\n";
    page +=
        "It is not a stage of a pipeline. It recognises its folders itself, or is selected by "
        "`--dataset` or by a file `dataset.yaml` beside the data: [Data "
        "sets](../data_sets.md).\n\n";
  } else if (kind == PipelineFamily::kKind) {
    page += "A plugin of this kind " + text +
            ": its parameters are the keys there. A file names it with "
            "`type: NAME`; without `type` it is `" +
            std::string(PipelineFamily::kDefault) + "`.\n\n";
  } else {
    page += article + kind + " stage " + text + ".\n\n";
    page += "In a pipeline: " + places(registry, kind) + ".\n\n";
  }
  page += "In C++: " + header_of(kind) + ".\n\n";
  for (const PluginInfo* plugin : registry.plugins(kind)) page += describe_markdown(*plugin);
  page.pop_back();  // a page ends with one line end
  return page;
}

std::string index(const Registry& registry) {
  std::string text = kNote + std::string("\n# Reference of the plugins\n");
  for (const auto& [kind, meaning] : registry.kinds()) {
    text += "\n**[" + kind + "](" + kind + ".md)** " + meaning + "\n";
    for (const PluginInfo* plugin : registry.plugins(kind)) {
      text += "- [`" + plugin->name + "`](" + kind + ".md#" + plugin->name +
              "): " + plugin->summary + "\n";
    }
  }
  return text;
}

// File name to content.
std::map<std::string, std::string> pages(const Registry& registry) {
  std::map<std::string, std::string> pages{{"README.md", index(registry)}};
  for (const auto& [kind, meaning] : registry.kinds()) {
    pages[kind + ".md"] = page(registry, kind, meaning);
  }
  return pages;
}

}  // namespace

TEST_CASE("the pages in docs/reference are up to date") {
  INFO("if not: make reference");
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    const std::string name = entry.path().filename().string();
    if (is_known(name)) found.insert(name);
  }
  for (const auto& page : pages(all_plugins())) {
    if (!is_known(page.first)) continue;
    REQUIRE_MESSAGE(found.erase(page.first) == 1, page.first, " is missing");
    CHECK_MESSAGE(read_file((kFolder / page.first).string()) == page.second, page.first,
                  " is stale");
  }
  for (const std::string& name : found) FAIL_CHECK(name, " belongs to no kind; remove it");
}

#ifdef XGM_HAS_ALL_PLUGINS
TEST_CASE("a build without geo knows which pages it cannot judge") {
  const auto of_core = pages(builtins());
  std::set<std::string> others;
  for (const auto& [name, text] : pages(all_plugins())) {
    const auto same = of_core.find(name);
    if (same == of_core.end() || same->second != text) others.insert(name);
  }
  CHECK(others == kPagesOfGeo);
}
#endif

TEST_CASE("write docs/reference" * doctest::skip()) {
  for (const auto& [name, text] : pages(all_plugins())) {
    if (is_known(name)) write_file((kFolder / name).string(), text);
  }
}
