// SPDX-License-Identifier: Apache-2.0
// A typed place for a stage: bound by the configuration, called like a function.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "xgm/config/slot_base.hpp"
#include "xgm/stage/context.hpp"

namespace xgm {

/// Holds one stage of kind `Kind`. slot(context, inputs...) runs it as the part of the pipeline
/// that bears this slot's name: timed, logged, its errors carrying its path. What it returns is
/// checked by Kind::fault_of(result, inputs..., context), if the kind has such a
/// function; else a map by the rules of all maps. Kind::complete(result, inputs...) then adds what
/// stages of the kind hand on without looking at it.
template <class Kind>
class Slot final : public SlotBase {
 public:
  Slot() = default;
  /// For use from C++: a slot that holds `stage`, called `field` in paths.
  explicit Slot(std::shared_ptr<const Kind> stage, std::string field = std::string(Kind::kKind))
      : stage_(std::move(stage)), plugin_(Kind::kKind), field_(std::move(field)) {}

  std::string_view kind() const override { return Kind::kKind; }
  bool assign(std::shared_ptr<const Stage> stage, std::string plugin, std::string field,
              std::set<const Stage*> matchers) override {
    stage_ = std::dynamic_pointer_cast<const Kind>(std::move(stage));
    plugin_ = std::move(plugin);
    field_ = std::move(field);
    matchers_ = std::move(matchers);
    return stage_ != nullptr;
  }

  explicit operator bool() const { return stage_ != nullptr; }
  const Kind* operator->() const { return stage_.get(); }
  const Kind& stage() const { return *stage_; }
  const std::string& plugin() const { return plugin_; }
  /// The matchers that the configuration has put here, stages inside stages included. Equal ones
  /// are one.
  const std::set<const Stage*>& matchers() const { return matchers_; }

  template <class... Inputs>
  auto operator()(const Context& context, const Inputs&... inputs) const {
    Context inner = context.inside(field_, Kind::kKind, plugin_, *stage_);
    (inner.take_view(inputs), ...);
    return inner.run_stage([&](const Context& here) {
      (here.show_input(inputs), ...);
      auto result = answer(here, inputs...);
      if constexpr (requires { Kind::fault_of(result, inputs..., here); }) {
        here.require_none(Kind::fault_of(result, inputs..., here));
      } else if constexpr (requires { fault_of(result, MapBounds{result.size()}); }) {
        here.require_none(fault_of(result, MapBounds{result.size()}));
      }
      if constexpr (requires { Kind::complete(result, inputs...); }) {
        Kind::complete(result, inputs...);
      }
      if constexpr (requires { Kind::watched(std::move(result), here); }) {
        return Kind::watched(std::move(result), here);
      } else {
        return result;
      }
    });
  }

 private:
  template <class... Inputs>
  auto answer(const Context& here, const Inputs&... inputs) const {
    if constexpr (requires { Kind::answer(*stage_, inputs..., here); }) {
      return Kind::answer(*stage_, inputs..., here);
    } else {
      return stage_->run(inputs..., here);
    }
  }

  std::shared_ptr<const Kind> stage_;
  std::string plugin_, field_;
  std::set<const Stage*> matchers_;
};

/// Any number of stages of one kind, in order.
template <class Kind>
class SlotList final : public SlotListBase {
 public:
  std::string_view kind() const override { return Kind::kKind; }
  SlotBase& append() override { return slots_.emplace_back(); }

  bool empty() const { return slots_.empty(); }
  std::size_t size() const { return slots_.size(); }
  auto begin() const { return slots_.begin(); }
  auto end() const { return slots_.end(); }

 private:
  std::vector<Slot<Kind>> slots_;
};

}  // namespace xgm
