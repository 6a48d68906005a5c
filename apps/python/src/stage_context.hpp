// SPDX-License-Identifier: Apache-2.0
// What a stage in Python knows of its run: xgm::Context, for as long as the stage runs.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "xgm/stage/context.hpp"

namespace xgm::python {
namespace py = pybind11;

/// Python may keep the object longer than the run: it is then of no use, and says so.
class StageContext {
 public:
  static void bind(py::module_& module);

  /// Makes an object, and takes the run away from it at its end.
  class Lease {
   public:
    explicit Lease(const Context& context) : shared_(std::make_shared<StageContext>()) {
      shared_->context_ = &context;
    }
    ~Lease() { shared_->context_ = nullptr; }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    py::object object() const { return py::cast(shared_); }

   private:
    std::shared_ptr<StageContext> shared_;
  };

 private:
  const Context& get() const;

  const Context* context_ = nullptr;
};

}  // namespace xgm::python
