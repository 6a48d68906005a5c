// SPDX-License-Identifier: Apache-2.0
#include "plugin/unknown_plugin.hpp"

#include "xgm/base/suggest.hpp"

namespace xgm {

std::string unknown_plugin_remedy(std::string_view written, const std::vector<std::string>& known,
                                  const std::string& label) {
  const std::string remedy = suggest(written, known, label);
  if (!closest(written, known).empty()) return remedy;
  return remedy + (remedy.empty() ? "" : "; ") +
         "if it is a plugin of your own, load its file: --plugin FILE, XGM_PLUGIN_PATH, or in "
         "Python xgm.load_plugin";
}

}  // namespace xgm
