// SPDX-License-Identifier: Apache-2.0
// The base of all stages.
#pragma once

#include "xgm/base/export.hpp"

namespace xgm {

/// A step of a pipeline with its parameters bound: immutable, so that several threads may run it.
/// The kinds (Cost, Aggregation, ...) derive from it, each with a function run() of its own.
class XGM_API Stage {
 public:
  virtual ~Stage();
};

}  // namespace xgm
