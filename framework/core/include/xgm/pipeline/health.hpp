// SPDX-License-Identifier: Apache-2.0
// What a program finds of itself and of its machine, for those who ask why something does not work.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/base/json.hpp"
#include "xgm/plugin/registry.hpp"

namespace xgm {

enum class Health {
  good,
  missing,  ///< an optional part is not there
  broken,   ///< does not work as it should
};

/// "good", "missing", "broken"
XGM_API const char* to_string(Health health);

struct Finding {
  std::string topic;  ///< "memory"; several findings may have one
  Health health = Health::good;
  std::string text{};           ///< what was found; if it is not good, what to do
  Json facts = Json::object();  ///< the same for programs
};

/// The version and its libraries, the processor, threads, memory, and the folder for temporary
/// files.
XGM_API std::vector<Finding> examine_machine();

/// Where plugin files are looked for by themselves, those that were loaded, and those that were
/// not.
XGM_API std::vector<Finding> examine_plugins(const Registry& registry);

/// The shipped pipelines. One that lacks a part which the registry says is missing is missing, too;
/// any other that is not sound is broken.
XGM_API std::vector<Finding> examine_pipelines(const Registry& registry);

}  // namespace xgm
