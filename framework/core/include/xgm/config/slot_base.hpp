// SPDX-License-Identifier: Apache-2.0
// A slot: a place for a stage among the parameters of another stage, as the binder uses it.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "xgm/base/export.hpp"

namespace xgm {

class Stage;  // xgm/stage/stage.hpp

class XGM_API SlotBase {
 public:
  virtual ~SlotBase();
  /// Name of the kind of stage that fits ("cost", "filter", ...).
  virtual std::string_view kind() const = 0;
  /// Puts a stage into the slot. Returns false if it is of another kind. `plugin` is the name of
  /// its plugin, `field` the name of the slot ("cost", "filters[1]"), `matchers` those among the
  /// stage and the stages inside it.
  virtual bool assign(std::shared_ptr<const Stage> stage, std::string plugin, std::string field,
                      std::set<const Stage*> matchers) = 0;
};

class XGM_API SlotListBase {
 public:
  virtual ~SlotListBase();
  virtual std::string_view kind() const = 0;
  virtual SlotBase& append() = 0;
};

}  // namespace xgm
