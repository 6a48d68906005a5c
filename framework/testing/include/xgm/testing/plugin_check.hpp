// SPDX-License-Identifier: Apache-2.0
// The contracts of all stages in a plugin file, whatever the file does to the process it is in.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/pipeline/pipeline.hpp"
#include "xgm/testing/contract.hpp"

namespace xgm::testing {

struct PluginCheck {
  std::string file;
  /// Of stages that cannot be made by their name alone: path "NAME.parameter".
  std::vector<Override> parameters{};
  double seconds = 60;  ///< that a check may take
};

/// One check of one stage: it is passed if it was made and nothing is wrong.
struct XGM_API CheckVerdict {
  std::string name;
  std::vector<std::string> faults{};
  bool is_skipped = false;  ///< the stage died before its turn

  bool passed() const { return faults.empty() && !is_skipped; }
};

struct XGM_API StageVerdict {
  std::string kind, name;
  std::vector<CheckVerdict> checks{};
  std::string failure{};  ///< why it was not checked, or not to the end; else empty

  bool passed() const;
};

struct XGM_API PluginVerdict {
  std::vector<StageVerdict> stages{};
  std::string failure{};  ///< why the file was not loaded; else empty

  bool passed() const;
};

/// Loads the file beside the plugins of `registry` and checks every stage of it. What runs the
/// file's code are child processes: one for each stage, and one to load the file. For programs that
/// have no thread but the calling one, and have made no loop of several threads before. Throws
/// UsageError if a parameter is of no stage of the file.
XGM_API PluginVerdict check_plugin(const PluginCheck& check, const Registry& registry);

/// One object: {file, passed, message, stages}.
/// - stages: {kind, name, passed, message, checks}
/// - checks: {name, result, messages}; the result is "passed", "failed" or "skipped"
/// A message is null if there is none. docs/write_a_plugin.md says more.
XGM_API std::string to_json(const std::string& file, const PluginVerdict& verdict);

}  // namespace xgm::testing
