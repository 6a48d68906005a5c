// SPDX-License-Identifier: Apache-2.0
#include "plugins/pipeline/stereo/found_on_whole.hpp"

#include "xgm/base/error.hpp"

namespace xgm::stereo {

Json record_of(const std::string& plugin, const PartPreprocess* fitted, const Context& context) {
  const std::string text = fitted == nullptr ? "" : fitted->state();
  if (fitted != nullptr && text.empty()) {
    context.warn("'" + plugin +
                 "' cannot hand on what it finds on the whole scene: each process looks at all of "
                 "it again");
  }
  return {{"stage", plugin},
          {"fitted", fitted != nullptr},
          {"state", text.empty() ? Json() : Json::parse(text)}};
}

std::shared_ptr<const PartPreprocess> fitted_by(const Json& record, const std::string& plugin,
                                                const Preprocess& stage, const PairWindows& scene,
                                                const Context& context) {
  if (record.at("stage").text() != plugin) {
    throw Error("'" + record.at("stage").text() + "' has looked at the whole scene and not '" +
                plugin + "'; let this pipeline look again");
  }
  if (!std::get<bool>(record.at("fitted").plain())) return nullptr;
  const Json& state = record.at("state");
  if (state.is_null()) return stage.fitted(scene, context);
  auto fitted = stage.restored(state.dump(), scene.size());
  if (fitted != nullptr) return fitted;
  throw Error("'" + plugin + "' cannot go on from what it has found on the whole scene, " +
              state.dump() + "; use the plugin that has found it, or let it look again");
}

}  // namespace xgm::stereo
