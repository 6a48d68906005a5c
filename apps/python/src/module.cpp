// SPDX-License-Identifier: Apache-2.0
// The module xgm._native.
#include <pybind11/pybind11.h>

#include "bindings.hpp"
#include "errors.hpp"
#include "xgm/plugin/version.hpp"

PYBIND11_MODULE(_native, module) {
  using namespace xgm::python;
  module.doc() = "The C++ library behind the package xgm, which is what programs import.";
  module.attr("version") = XGM_VERSION;
  translate_errors();
  bind_registry(module);
  bind_requests(module);
  bind_runs(module);
  bind_surfaces(module);
  bind_stages(module);
  bind_evaluation(module);
  bind_files(module);
  bind_bench(module);
}
