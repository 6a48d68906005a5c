// SPDX-License-Identifier: Apache-2.0
// Plugin files: found, opened, compared by their handshake, and only then asked for their stages.
#include <dlfcn.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <optional>

#include "config/node.hpp"
#include "xgm/base/error.hpp"
#include "xgm/plugin/handshake.hpp"

namespace xgm {
namespace {

namespace fs = std::filesystem;

// "libxgm_blur.so" and "blur.so" are both called blur until the file says its name itself.
std::string name_from(const fs::path& file) {
  std::string stem = file.stem().string();
  for (const std::string prefix : {"lib", "xgm_"}) {
    if (stem.starts_with(prefix)) stem.erase(0, prefix.size());
  }
  return stem;
}

// Why the file cannot be used, if so.
std::optional<std::string> objection(const xgm_plugin_handshake& handshake) {
  if (handshake.abi != XGM_PLUGIN_ABI) {
    return "was built for plugin ABI " + std::to_string(handshake.abi) + ", this is ABI " +
           std::to_string(XGM_PLUGIN_ABI) + "; build it again with this version's SDK";
  }
  if (std::string_view(handshake.build_tag) != XGM_BUILD_TAG) {
    return "was built with " + std::string(handshake.build_tag) + ", this is " + XGM_BUILD_TAG +
           "; build it again with the same compiler and libraries";
  }
  if (handshake.add == nullptr)
    return "has a handshake that adds no stages; use XGM_PLUGIN(registry) {...}";
  return std::nullopt;
}

// Opens the file and returns its handshake; throws Error with the reason. The library stays open
// for the life of the process, because its code is in use from now on.
const xgm_plugin_handshake& open(const std::string& file) {
  std::error_code unusable;
  if (!fs::exists(file, unusable)) throw Error("there is no such file");
  // A bare name would be looked up in the system's library path instead of the current folder.
  void* library = dlopen(fs::absolute(file).c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) throw Error("not a loadable shared object: " + std::string(dlerror()));
  using Entry = const xgm_plugin_handshake* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(library, "xgm_plugin"));
  if (entry == nullptr) {
    dlclose(library);
    throw Error("has no symbol 'xgm_plugin'; a plugin's source holds XGM_PLUGIN(registry) {...}");
  }
  const xgm_plugin_handshake* handshake = entry();
  if (handshake == nullptr || handshake->build_tag == nullptr || handshake->name == nullptr) {
    throw Error("its symbol 'xgm_plugin' gives no handshake; use XGM_PLUGIN(registry) {...}");
  }
  return *handshake;
}

}  // namespace

bool Registry::load(const std::string& file) {
  LoadFailure failure{file, name_from(file), {}, {}, false};
  Registry loaded;
  const auto refuse = [&](const std::string& reason) {
    failure.reason = without_controls(reason);
    for (const auto& [key, info] : loaded.plugins_) failure.provides.insert(info.name);
    failures_.push_back(std::move(failure));
    return false;
  };
  try {
    const xgm_plugin_handshake& handshake = open(file);
    failure.name = without_controls(handshake.name);
    if (const auto reason = objection(handshake)) throw Error(*reason);
    loaded.kinds_ = kinds_;
    handshake.add(&loaded);
    failure.named_all = true;
    for (const auto& [key, info] : loaded.plugins_) {
      if (find(info.kind, info.name) != nullptr) Registry(*this).add(info);  // throws: name taken
    }
  } catch (const std::exception& error) {
    const std::string reason = error.what();
    return refuse(reason.empty() ? "threw an exception without a message while it was registering"
                                 : reason);
  } catch (...) {
    return refuse("threw something that is not an exception while it was registering");
  }
  kinds_ = std::move(loaded.kinds_);
  for (auto& [key, info] : loaded.plugins_) {
    info.origin = file;
    add(std::move(info));
  }
  return true;
}

void Registry::load_path(const std::string& path_list) {
  for (std::size_t begin = 0; begin <= path_list.size();) {
    const std::size_t end = std::min(path_list.find(':', begin), path_list.size());
    const fs::path place = path_list.substr(begin, end - begin);
    begin = end + 1;
    if (place.empty()) continue;
    std::error_code unusable;
    if (!fs::is_directory(place, unusable)) {
      load(place.string());
      continue;
    }
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(place, unusable)) {
      if (entry.path().extension() == ".so") files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    if (unusable) failures_.push_back({place.string(), "", unusable.message(), {}});
    for (const std::string& file : files) load(file);
  }
}

}  // namespace xgm
