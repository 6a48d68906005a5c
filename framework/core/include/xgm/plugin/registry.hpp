// SPDX-License-Identifier: Apache-2.0
// The plugins that configurations can name. An object, not a singleton: a program may have several.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/config/parameters.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

/// A stage about to be made: its parameters, open for binding.
class XGM_API Prototype {
 public:
  virtual ~Prototype();
  virtual ParameterSet& parameters() = 0;
  virtual std::shared_ptr<const Stage> build() = 0;
};

struct PluginInfo {
  std::string kind;
  std::string name;
  std::string summary;      ///< one sentence
  std::string publication;  ///< where the algorithm comes from; may be empty
  std::string origin;       ///< file it was loaded from; empty for built-in plugins
  std::function<std::unique_ptr<Prototype>()> prototype;
};

/// A plugin file that could not be loaded.
struct LoadFailure {
  std::string file;
  std::string name;  ///< what the file calls itself, or its stem
  std::string reason;
  std::set<std::string> provides;  ///< stages it had named before it failed
  bool named_all = false;          ///< it has no other stages
};

/// A kind of stage.
struct KindInfo {
  std::string name;
  std::string meaning;  ///< what its stages do: "picks one disparity per pixel"
};

class XGM_API Registry {
 public:
  /// With the kinds of the core, and no plugins.
  Registry();
  /// With all plugins that are part of the library, too.
  static Registry with_builtins();

  /// Adds kind K: a class that derives from Stage and has K::kKind and K::kMeaning. What is known
  /// of a kind comes from here; the core lists none of another room or plugin file. Naming one
  /// twice is no mistake if the meaning is the same, else throws Error.
  template <class K>
  void add_kind() {
    add(KindInfo{std::string(K::kKind), std::string(K::kMeaning)});
  }
  void add(KindInfo kind);

  /// Adds stage class T under `name`. T derives from a kind, has a struct T::Parameters with
  /// defaults, a static void describe(Parameters&, ParameterSet&) and a constructor T(Parameters).
  /// Throws Error if there is no such kind, or if it has that name already.
  template <class T>
  void add(std::string name, std::string summary, std::string publication = {}) {
    add(PluginInfo{
        std::string(T::kKind), std::move(name), std::move(summary), std::move(publication), {}, [] {
          return std::make_unique<PrototypeOf<T>>();
        }});
  }
  void add(PluginInfo info);
  /// Takes a plugin away, so that another one can have its name; false if there is none. Pipelines
  /// that hold its stages keep them.
  bool remove(std::string_view kind, std::string_view name);

  /// Loads a plugin file and adds what it holds; on failure records why, adds nothing, returns
  /// false.
  bool load(const std::string& file);
  /// Loads every shared object in the directories and files of a colon-separated list.
  void load_path(const std::string& path_list);

  const PluginInfo* find(std::string_view kind, std::string_view name) const;
  /// All plugins of a kind (of all kinds if empty), sorted by kind and name.
  std::vector<const PluginInfo*> plugins(std::string_view kind = {}) const;
  /// All plugins called `name`, whatever their kind.
  std::vector<const PluginInfo*> named(std::string_view name) const;
  /// For what a program lacks: whoever names it reads why.
  void add(LoadFailure failure) { failures_.push_back(std::move(failure)); }
  const std::vector<LoadFailure>& failures() const { return failures_; }

  /// Every kind of stage there is: those of the core in the order data flows, then others.
  const std::vector<KindInfo>& kinds() const { return kinds_; }
  bool has_kind(std::string_view kind) const;

 private:
  template <class T>
  class PrototypeOf final : public Prototype {
   public:
    PrototypeOf() { T::describe(parameters_, set_); }
    ParameterSet& parameters() override { return set_; }
    std::shared_ptr<const Stage> build() override { return std::make_shared<const T>(parameters_); }

   private:
    typename T::Parameters parameters_;
    ParameterSet set_;
  };

  std::vector<KindInfo> kinds_;
  std::map<std::pair<std::string, std::string>, PluginInfo, std::less<>> plugins_;
  std::vector<LoadFailure> failures_;
};

}  // namespace xgm
