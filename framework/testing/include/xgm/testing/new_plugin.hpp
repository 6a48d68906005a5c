// SPDX-License-Identifier: Apache-2.0
// Begins a plugin: a folder that builds, is tested, and holds the least code of its kind.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/plugin/registry.hpp"

namespace xgm::testing {

enum class Language { cpp, python };

struct NewPlugin {
  std::string kind;
  std::string name;
  std::string folder;  ///< is made, and must not be there
  Language language = Language::cpp;
};

/// The folder of the templates, share/xgm/new_plugin below the prefix of the library; "" if there
/// is none.
XGM_API std::string templates_folder();

/// The kinds that plugins can be begun for, sorted.
XGM_API std::vector<std::string> template_kinds(Language language);

/// Writes the folder: all of it, or nothing. Throws UsageError if the kind has no template, the
/// name is none or is taken, or the folder is there; Error if it cannot be written.
XGM_API void write_new_plugin(const NewPlugin& plugin, const Registry& registry);

}  // namespace xgm::testing
