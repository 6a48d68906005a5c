// SPDX-License-Identifier: Apache-2.0
// The pages in docs/reference are what the plugins say of themselves. `make reference` writes them.
#include <doctest/doctest.h>

#include <filesystem>
#include <map>
#include <set>

#include "docs/blocks.hpp"
#include "support/support.hpp"
#include "xgm/io/file.hpp"
#include "xgm/pipeline/describe.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

const std::filesystem::path kFolder = std::filesystem::path(XGM_SOURCE_DIR) / "docs/reference";

constexpr const char* kNote = "<!-- Generated from the plugins by `make reference`. -->\n";

std::string kind_of(const Field& field) {
  if (const auto* slot = std::get_if<SlotBase*>(&field.target)) {
    return std::string((*slot)->kind());
  }
  if (const auto* slots = std::get_if<SlotListBase*>(&field.target)) {
    return std::string((*slots)->kind());
  }
  return {};
}

// Where in a pipeline a stage of this kind may stand.
std::string places(const std::string& kind) {
  std::string text;
  const auto add = [&](const std::string& place) { text += (text.empty() ? "" : ", ") + place; };
  for (const PluginInfo* plugin : builtins().plugins()) {
    const auto prototype = plugin->prototype();
    for (const Field& field : prototype->parameters().fields()) {
      if (kind_of(field) != kind) continue;
      const bool top = plugin->kind == PipelineFamily::kKind;
      add("`" + field.name + "` of " + (top ? "the file" : "`" + plugin->name + "`"));
    }
  }
  return text;
}

std::string page(const std::string& kind, const std::string& text) {
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
    page += "In a pipeline: " + places(kind) + ".\n\n";
  }
  page += "In C++: [`xgm/stage/" + kind + ".hpp`](../../framework/core/include/xgm/stage/" + kind +
          ".hpp).\n\n";
  for (const PluginInfo* plugin : builtins().plugins(kind)) page += describe_markdown(*plugin);
  page.pop_back();  // a page ends with one line end
  return page;
}

std::string index() {
  std::string text = kNote + std::string("\n# Reference of the plugins\n");
  for (const auto& [kind, meaning] : builtins().kinds()) {
    text += "\n**[" + kind + "](" + kind + ".md)** " + meaning + "\n";
    for (const PluginInfo* plugin : builtins().plugins(kind)) {
      text += "- [`" + plugin->name + "`](" + kind + ".md#" + plugin->name +
              "): " + plugin->summary + "\n";
    }
  }
  return text;
}

// File name to content.
std::map<std::string, std::string> pages() {
  std::map<std::string, std::string> pages{{"README.md", index()}};
  for (const auto& [kind, meaning] : builtins().kinds()) pages[kind + ".md"] = page(kind, meaning);
  return pages;
}

}  // namespace

TEST_CASE("the pages in docs/reference are up to date") {
  INFO("if not: make reference");
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    found.insert(entry.path().filename().string());
  }
  for (const auto& page : pages()) {
    REQUIRE_MESSAGE(found.erase(page.first) == 1, page.first, " is missing");
    CHECK_MESSAGE(read_file((kFolder / page.first).string()) == page.second, page.first,
                  " is stale");
  }
  for (const std::string& name : found) FAIL_CHECK(name, " belongs to no kind; remove it");
}

TEST_CASE("write docs/reference" * doctest::skip()) {
  for (const auto& [name, text] : pages()) write_file((kFolder / name).string(), text);
}
