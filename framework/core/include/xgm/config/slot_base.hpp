// SPDX-License-Identifier: Apache-2.0
// A place for a stage inside another stage's parameters, as the YAML binder sees it.
#pragma once

#include <memory>
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
  /// Puts a stage in. False if it is of another kind. `plugin` is its name, `field` the name of
  /// this place ("cost", "filters[1]").
  virtual bool assign(std::shared_ptr<const Stage> stage, std::string plugin,
                      std::string field) = 0;
};

class XGM_API SlotListBase {
 public:
  virtual ~SlotListBase();
  virtual std::string_view kind() const = 0;
  virtual SlotBase& append() = 0;
};

}  // namespace xgm
