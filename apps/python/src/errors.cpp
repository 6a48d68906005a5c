// SPDX-License-Identifier: Apache-2.0
#include "errors.hpp"

#include <utility>

#include "xgm/base/error.hpp"

namespace xgm::python {
namespace {

thread_local PyObject* kept_cause = nullptr;

py::object instance(const char* type, const Error& error) {
  const py::object exception = py::module_::import("xgm._errors").attr(type);
  return exception(error.message(), error.stage_path());
}

/// The package's exception, or none if it is of another library.
py::object to_python(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const Cancelled& cancelled) {
    return instance("Cancelled", cancelled);
  } catch (const UsageError& mistake) {
    return instance("UsageError", mistake);
  } catch (const Error& failure) {
    return instance("Error", failure);
  } catch (...) {
    return py::none();
  }
}

void set(const py::object& exception) {
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(exception.ptr())), exception.ptr());
}

}  // namespace

void translate_errors() {
  py::register_exception_translator([](std::exception_ptr error) {
    const py::object exception = to_python(error);
    if (exception.is_none()) std::rethrow_exception(error);
    set(exception);
  });
}

void raise_in_python(const std::exception_ptr& error, const py::object& cause) {
  const py::object exception = to_python(error);
  if (exception.is_none()) std::rethrow_exception(error);
  if (cause && !cause.is_none()) {
    PyException_SetCause(exception.ptr(), py::object(cause).release().ptr());
  }
  set(exception);
  throw py::error_already_set();
}

void throw_as_error(py::error_already_set& raised, const std::string& what) {
  const std::string type = py::str(raised.type().attr("__name__"));
  std::string text = py::str(raised.value());
  for (char& sign : text) {
    if (sign == '\n') sign = ' ';
  }
  Py_XDECREF(std::exchange(kept_cause, py::object(raised.value()).release().ptr()));
  if (raised.trace()) PyException_SetTraceback(kept_cause, raised.trace().ptr());
  throw Error(what + " raised " + type + (text.empty() ? "" : ": " + text));
}

PyObject* take_cause() { return std::exchange(kept_cause, nullptr); }

}  // namespace xgm::python
