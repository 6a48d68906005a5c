// SPDX-License-Identifier: Apache-2.0
// The handshake of a plugin file, and the registration that follows. The first byte of the input is
// a set of deviations; then come, a line each, the build tag, the file's name, and the name of the
// kind and of each plugin that it adds.
#include <dlfcn.h>

#include <sstream>
#include <stdexcept>

#include "fuzz/support/target.hpp"
#include "xgm/plugin.hpp"
#include "xgm/plugin/handshake.hpp"

namespace xgm::fuzz {
namespace {

enum Deviation : unsigned {
  kOtherAbi = 1,
  kOtherTag = 2,
  kNoTag = 4,
  kNoName = 8,
  kAddsNothing = 16,
  kThrows = 32,
  kThrowsNumber = 64,
};

/// A declaration, which the handshake's function `add` can only find in a global.
struct Declaration {
  unsigned deviations = 0;
  std::string tag, name, kind;
  std::vector<std::string> plugins;
} declared;

void read_declaration(std::string_view input) {
  declared = {};
  if (!input.empty()) declared.deviations = static_cast<unsigned char>(input.front());
  std::istringstream lines(std::string(input.substr(input.empty() ? 0 : 1)));
  std::getline(lines, declared.tag);
  std::getline(lines, declared.name);
  std::getline(lines, declared.kind);
  for (std::string plugin; std::getline(lines, plugin);) declared.plugins.push_back(plugin);
}

void add_declared(void* target) {
  auto& registry = *static_cast<Registry*>(target);
  const auto like = builtins().plugins().front();
  for (const std::string& name : declared.plugins) {
    PluginInfo info = *like;
    if (!declared.kind.empty()) info.kind = declared.kind;
    info.name = name;
    registry.add(std::move(info));
  }
  if (declared.deviations & kThrows) throw std::runtime_error("no licence for this machine");
  if (declared.deviations & kThrowsNumber) throw 42;
}

xgm_plugin_handshake& handshake_of_file() {
  void* const library = ::dlopen(XGM_FUZZ_PLUGIN, RTLD_LAZY | RTLD_LOCAL);
  require(library != nullptr, "the plugin file is there");
  using Entry = const xgm_plugin_handshake* (*)();
  const auto entry = reinterpret_cast<Entry>(::dlsym(library, "xgm_plugin"));
  return const_cast<xgm_plugin_handshake&>(*entry());  // it is no constant there
}

void declare(xgm_plugin_handshake& handshake) {
  const unsigned deviations = declared.deviations;
  handshake.abi = XGM_PLUGIN_ABI + ((deviations & kOtherAbi) != 0 ? 1 : 0);
  handshake.build_tag = (deviations & kNoTag) != 0      ? nullptr
                        : (deviations & kOtherTag) != 0 ? declared.tag.c_str()
                                                        : XGM_BUILD_TAG;
  handshake.name = (deviations & kNoName) != 0 ? nullptr : declared.name.c_str();
  handshake.add = (deviations & kAddsNothing) != 0 ? nullptr : add_declared;
}

}  // namespace

void check(std::string_view input) {
  static xgm_plugin_handshake& handshake = handshake_of_file();
  read_declaration(input);
  declare(handshake);
  Registry registry = builtins();
  const std::size_t before = registry.plugins().size();
  if (registry.load(XGM_FUZZ_PLUGIN)) {
    require(registry.failures().empty(), "what is loaded is no failure");
    require(registry.plugins().size() == before + declared.plugins.size(), "all plugins are there");
  } else {
    require(registry.plugins().size() == before, "what fails adds nothing");
    require(registry.failures().size() == 1, "a failure is told once");
    const LoadFailure& failure = registry.failures().front();
    require(failure.file == XGM_FUZZ_PLUGIN, "a failure names the file");
    require(!failure.reason.empty(), "a failure has a reason");
    require(failure.reason.find('\n') == std::string::npos, "a reason is one line");
  }
}

std::vector<std::string> seeds() {
  const std::string rest = std::string(XGM_BUILD_TAG) + "\nblur\nfilter\nblur\nsharpen";
  std::vector<std::string> all;
  for (const unsigned deviations : {0u, 1u, 2u, 4u, 8u, 16u, 32u, 64u}) {
    all.push_back(static_cast<char>(deviations) + rest);
  }
  return all;
}

std::vector<std::string> words() {
  return {XGM_BUILD_TAG, "\nfilter\n", "\ncost\ncensus", "\n\n", "g++ 12", "\033[2J"};
}

}  // namespace xgm::fuzz
