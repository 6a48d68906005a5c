// SPDX-License-Identifier: Apache-2.0
// Plugin files that cannot be loaded say why, and disturb nobody who does not use them.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "support/fake_stages.hpp"
#include "support/paths.hpp"
#include "xgm/pipeline/pipeline.hpp"
#include "xgm/plugin/handshake.hpp"

namespace fs = std::filesystem;
using namespace xgm;

namespace {

// Built from tests/out_of_tree/broken.
std::string broken(const std::string& name) {
  return std::string(XGM_BINARY_DIR) + "/tests/broken_plugins/xgm_" + name + ".so";
}

// A folder of its own, gone with the test.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(fs::path(XGM_BINARY_DIR) / "tests" / ("loading_" + name)) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string path() const { return path_.string(); }
  std::string file(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / name) << content;
    return (path_ / name).string();
  }
  void link(const std::string& plugin) const {
    fs::create_symlink(broken(plugin), path_ / (plugin + ".so"));
  }

 private:
  fs::path path_;
};

std::size_t plugin_count(const Registry& registry) { return registry.plugins().size(); }

LoadedPipeline load_with_filter(const std::string& filter, const Registry& registry) {
  return load_pipeline_text(
      "xgm: 1\nmatcher: {type: fake_matcher, cost: fake_cost}\npostprocess: [" + filter + "]\n",
      "test.yaml", registry);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("every way in which a plugin file can be bad has a message of its own") {
  const Folder folder("messages");
  const std::map<std::string, std::string> expected{
      {broken("wrong_abi"), "was built for plugin ABI " + std::to_string(XGM_PLUGIN_ABI + 1) +
                                ", this is ABI " + std::to_string(XGM_PLUGIN_ABI)},
      {broken("wrong_tag"), "was built with another compiler, this is "},
      {broken("no_symbol"), "has no symbol 'xgm_plugin'"},
      {broken("no_handshake"), "'xgm_plugin' gives no handshake"},
      {broken("adds_nothing"), "has a handshake that adds no stages"},
      {broken("throws_silently"), "threw an exception without a message"},
      {broken("throws"), "no licence for this machine"},
      {broken("throws_number"), "threw something that is not an exception"},
      {broken("name_taken"), "there is already a filter called 'fake_filter' (built in)"},
      {broken("name_twice"), "there is already a filter called 'twin'"},
      {folder.file("text.so", std::string(1000, 'x')), "invalid ELF header"},
      {folder.file("empty.so", ""), "file too short"},
      {folder.path() + "/absent.so", "there is no such file"},
  };
  std::set<std::string> reasons;
  for (const auto& entry : expected) {
    const std::string& file = entry.first;
    CAPTURE(file);
    Registry registry = xgm::testing::fake_registry();
    const std::size_t before = plugin_count(registry);
    CHECK_FALSE(registry.load(file));
    CHECK(plugin_count(registry) == before);
    REQUIRE(registry.failures().size() == 1);
    const LoadFailure& failure = registry.failures().front();
    CHECK(failure.file == file);
    CHECK_MESSAGE(contains(failure.reason, entry.second), failure.reason);
    CHECK_FALSE(contains(failure.reason, "\n"));
    reasons.insert(failure.reason);
  }
  CHECK(reasons.size() == expected.size());
}

TEST_CASE("a sound plugin works beside all the broken ones, whatever the order") {
  for (const bool sound_first : {true, false}) {
    Registry registry = xgm::testing::fake_registry();
    if (sound_first) CHECK(registry.load(broken("sound")));
    for (const std::string name : {"wrong_abi", "wrong_tag", "no_symbol", "no_handshake", "throws",
                                   "throws_number", "name_taken", "name_twice"}) {
      CHECK_FALSE(registry.load(broken(name)));
    }
    if (!sound_first) CHECK(registry.load(broken("sound")));
    REQUIRE(registry.find("filter", "sound") != nullptr);
    CHECK(registry.find("filter", "sound")->origin == broken("sound"));

    const LoadedPipeline loaded = load_with_filter("sound", registry);
    REQUIRE(loaded.pipeline);
    const Image image(cv::Mat1f(2, 3, 0.0F));
    const MatchResult result =
        loaded.pipeline->run({{image, image}, DisparityRange::uniform({3, 2}, {1, 2}), {}});
    CHECK(result.forward.disparity(1, 2) == 1.0F);
  }
}

TEST_CASE("a plugin that could not be loaded stops no pipeline that does not use it") {
  Registry registry = xgm::testing::fake_registry();
  registry.load(broken("throws"));
  const LoadedPipeline loaded = load_with_filter("fake_filter", registry);
  CHECK(loaded.pipeline);
  CHECK(loaded.diagnostics.empty());
}

TEST_CASE("a plugin that is used and could not be loaded is reported with path and reason") {
  Registry registry = xgm::testing::fake_registry();
  registry.load(broken("throws"));
  // By the name of the file's target, and by that of a stage it had named before it failed.
  for (const std::string name : {"throws", "half_way"}) {
    CAPTURE(name);
    const LoadedPipeline loaded = load_with_filter(name, registry);
    CHECK_FALSE(loaded.pipeline);
    REQUIRE(loaded.diagnostics.size() == 1);
    const std::string text = to_string(loaded.diagnostics.front());
    CHECK_MESSAGE(contains(text, "test.yaml:3:15: error: "), text);
    CHECK_MESSAGE(contains(text, "could not be loaded"), text);
    CHECK_MESSAGE(contains(text, broken("throws")), text);
    CHECK_MESSAGE(contains(text, "no licence for this machine"), text);
  }
}

TEST_CASE("an unknown name is not reported as one that could not be loaded") {
  Registry registry = xgm::testing::fake_registry();
  registry.load(broken("throws"));
  const LoadedPipeline loaded = load_with_filter("nobody", registry);
  REQUIRE(loaded.diagnostics.size() == 1);
  CHECK(contains(loaded.diagnostics.front().message, "there is no filter called 'nobody'"));
  CHECK_FALSE(contains(loaded.diagnostics.front().message, "could not be loaded"));
}

TEST_CASE("an unknown name is told what else may hold it: files of which not all is known") {
  Registry registry = xgm::testing::fake_registry();
  for (const char* file : {"name_taken", "no_symbol"}) registry.load(broken(file));
  const LoadedPipeline loaded = load_with_filter("nobody", registry);
  REQUIRE(loaded.diagnostics.size() == 1);
  const std::string& remedy = loaded.diagnostics.front().remedy;
  CHECK_MESSAGE(contains(remedy, "not loaded: " + broken("no_symbol")), remedy);
  CHECK_FALSE_MESSAGE(contains(remedy, broken("name_taken")), remedy);
}

TEST_CASE("an unknown name that is like no other is told with the ways to load plugins") {
  const Registry registry = xgm::testing::fake_registry();
  const auto remedy = [&](const std::string& name) {
    const LoadedPipeline loaded = load_with_filter(name, registry);
    REQUIRE(loaded.diagnostics.size() == 1);
    return loaded.diagnostics.front().remedy;
  };
  for (const char* way :
       {"known filter plugins: ", "--plugin FILE", "XGM_PLUGIN_PATH", "xgm.load_plugin"}) {
    CHECK_MESSAGE(contains(remedy("my_own_one"), way), remedy("my_own_one"));
  }
  CHECK(remedy("fake_fliter") == "did you mean 'fake_filter'?");
}

TEST_CASE("a path list holds files and folders, of which the shared objects are loaded by name") {
  const Folder folder("path");
  folder.link("sound");
  folder.link("throws");
  folder.file("README.txt", "no plugin");
  folder.file("a_junk.so", "junk");
  Registry registry = xgm::testing::fake_registry();
  registry.load_path(":" + folder.path() + ":" + broken("wrong_abi") + "::/nowhere");
  CHECK(registry.find("filter", "sound") != nullptr);
  std::vector<std::string> failed;
  for (const LoadFailure& failure : registry.failures()) failed.push_back(failure.name);
  CHECK(failed == std::vector<std::string>{"a_junk", "throws", "wrong_abi", "nowhere"});
}
