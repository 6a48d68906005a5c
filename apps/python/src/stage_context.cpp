// SPDX-License-Identifier: Apache-2.0
#include "stage_context.hpp"

#include "xgm/base/error.hpp"

namespace xgm::python {

const Context& StageContext::get() const {
  if (context_ == nullptr) throw Error("the stage that this context was given to has ended");
  return *context_;
}

void StageContext::bind(py::module_& module) {
  py::class_<StageContext, std::shared_ptr<StageContext>>(module, "Context")
      .def_property_readonly("path",
                             [](const StageContext& context) { return context.get().path(); })
      .def_property_readonly("cancelled",
                             [](const StageContext& context) { return context.get().cancelled(); })
      .def("progress",
           [](const StageContext& context, double share) { context.get().progress(share); })
      .def("info",
           [](const StageContext& context, const std::string& text) { context.get().info(text); })
      .def("warn",
           [](const StageContext& context, const std::string& text) { context.get().warn(text); })
      .def("figure", [](const StageContext& context, const std::string& name, double value) {
        context.get().figure(name, value);
      });
}

}  // namespace xgm::python
