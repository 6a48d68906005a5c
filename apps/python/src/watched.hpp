// SPDX-License-Identifier: Apache-2.0
// Work that another thread does while the caller's thread serves Python: signals, progress, log.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "xgm/pipeline/run_options.hpp"

namespace xgm::python {
namespace py = pybind11;

/// Python objects that are told of the work, each None or a callable; called by the thread that
/// called run_watched() alone, holding the interpreter's lock.
struct Hooks {
  py::object progress{};   ///< (share from 0 to 1, path of the stage), when they have changed
  py::object log{};        ///< (level, path, text); level is "debug", "info" or "warning"
  py::object cancelled{};  ///< () -> bool: whether somebody wants the work to end
};

/// Calls `body` on a thread of its own, without the interpreter's lock. What a signal handler
/// (Ctrl-C) or a hook raises ends the work and is raised here, after the work has ended.
void run_watched(const Hooks& hooks, int threads,
                 const std::function<void(const RunOptions&)>& body);

}  // namespace xgm::python
