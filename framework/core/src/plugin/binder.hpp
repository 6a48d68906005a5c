// SPDX-License-Identifier: Apache-2.0
// Builds stages from a configuration, and finds all that is wrong with it in one pass.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "config/node.hpp"
#include "xgm/base/json.hpp"
#include "xgm/plugin/registry.hpp"

namespace xgm {

class Binder {
 public:
  Binder(const Registry& registry, Diagnostics& diagnostics)
      : registry_(registry), diagnostics_(diagnostics) {}

  struct BoundStage {
    std::shared_ptr<const Stage> stage;  ///< null if anything inside is faulty
    std::string plugin;
    Json resolved;  ///< {"type": ..., every parameter}
  };

  /// The stage that `node` (a bare name, or a map with 'type') describes.
  BoundStage stage(const Node& node, std::string_view kind);

  /// The top of a pipeline file, which is a map: a stage of kind "pipeline". Its resolved
  /// configuration begins with the version of the format.
  BoundStage pipeline(const Node& root);

  struct BoundFields {
    bool good = true;
    Json resolved;
  };
  /// Binds the entries of a map to declared fields and checks the rules. `owner` is what the fields
  /// belong to, for messages. Keys in `skip` are not for the fields.
  BoundFields fields(const Node& map, ParameterSet& set, const std::string& owner,
                     const std::set<std::string>& skip = {});

 private:
  /// Equal matchers are one object, so that whoever holds several can see that they are equal.
  std::shared_ptr<const Stage> built(Prototype& prototype, std::string_view kind,
                                     const Json& resolved);
  const PluginInfo* find_plugin(const Node& name, std::string_view kind);
  std::string unknown_remedy(const std::string& name, std::string_view kind) const;
  /// What may stand for a stage of this kind, for people.
  std::string choices_of(std::string_view kind) const;
  void check_keys(const Node& map, const ParameterSet& set, const std::string& owner,
                  const std::set<std::string>& skip);
  bool bind(const Field& field, const Entry* entry, const Node& map, const std::string& owner,
            Json& resolved);
  bool bind_slot(const Field& field, SlotBase& slot, const Node& node, const std::string& place,
                 Json& resolved);
  bool bind_list(const Field& field, const Node& node, Json& resolved);
  /// Calls `body`, which runs code of the plugin: what it throws is a diagnostic.
  template <class Body>
  void with_plugin(const PluginInfo& plugin, const Location& where, const Body& body);
  void diagnose(const Location& where, std::string message, std::string remedy);

  const Registry& registry_;
  Diagnostics& diagnostics_;
  std::vector<std::pair<Json, std::shared_ptr<const Stage>>> matchers_;  ///< all that were built
  std::vector<const Stage*> bound_;  ///< the same, each as often as it stands in the file
};

}  // namespace xgm
