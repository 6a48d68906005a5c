// SPDX-License-Identifier: Apache-2.0
// Exceptions of the library as those of the package (xgm/_errors.py).
#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <string>

namespace xgm::python {
namespace py = pybind11;

/// Makes xgm::Error and those derived from it the package's exceptions, wherever they leave C++.
void translate_errors();

/// Throws the exception in Python's terms. `cause`, if it is set, is what a stage in Python raised.
[[noreturn]] void raise_in_python(const std::exception_ptr& error, const py::object& cause);

/// Throws an xgm::Error that says what was raised, and keeps the exception for take_cause() of the
/// same thread. The interpreter's lock is held. `what` is who raised it: "filter 'mine'".
[[noreturn]] void throw_as_error(py::error_already_set& raised, const std::string& what);

/// The exception that the last throw_as_error() of this thread was about, which is then forgotten;
/// null if there is none. The lock need not be held.
PyObject* take_cause();

}  // namespace xgm::python
