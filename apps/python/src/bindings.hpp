// SPDX-License-Identifier: Apache-2.0
// The parts of the module xgm._native. What users see is the package around it, in apps/python/xgm.
#pragma once

#include <pybind11/pybind11.h>

namespace xgm::python {

void bind_registry(pybind11::module_& module);
void bind_requests(pybind11::module_& module);
void bind_runs(pybind11::module_& module);
void bind_surfaces(pybind11::module_& module);
void bind_stages(pybind11::module_& module);
void bind_evaluation(pybind11::module_& module);
void bind_files(pybind11::module_& module);
void bind_bench(pybind11::module_& module);

}  // namespace xgm::python
