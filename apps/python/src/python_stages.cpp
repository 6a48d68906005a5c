// SPDX-License-Identifier: Apache-2.0
// Stages that call Python. What they hand over and take back is checked by xgm/_stage_calls.py.
#include <pybind11/stl.h>

#include <cmath>
#include <limits>
#include <map>

#include "arrays.hpp"
#include "bindings.hpp"
#include "declared_stage.hpp"
#include "errors.hpp"
#include "registry.hpp"
#include "stage_context.hpp"
#include "xgm/base/error.hpp"
#include "xgm/stage/cost.hpp"
#include "xgm/stage/filter.hpp"
#include "xgm/stage/matcher.hpp"
#include "xgm/stage/refinement.hpp"

namespace xgm::python {
namespace {

py::tuple shown(const Image& image) {
  py::list planes;
  for (const cv::Mat1f& plane : image.planes) planes.append(to_array(plane, false));
  return py::make_tuple(py::tuple(planes), to_array(image.valid, false));
}

py::tuple shown(const ImagePair& pair) {
  return py::make_tuple(shown(pair.base), shown(pair.match), pair.is_reverse);
}

py::tuple shown(const DisparityMap& map) {
  return py::make_tuple(to_array(map.disparity, false), to_array(map.status, false));
}

/// A copy: Python may keep its arrays.
DisparityMap taken(const py::object& result) {
  const auto arrays = result.cast<std::pair<py::array, py::array>>();
  return to_disparity_map(arrays.first, arrays.second).clone();
}

/// What all kinds have in common: the function, and what becomes of what it raises.
class PythonStage {
 public:
  PythonStage(Held function, std::string name)
      : function_(std::move(function)), name_(std::move(name)) {}

  /// `use(result)` is called while the interpreter's lock is held, as is `inputs()`.
  template <class Inputs, class Use>
  auto call(const Context& context, const Inputs& inputs, const Use& use) const {
    const py::gil_scoped_acquire acquire;
    const StageContext::Lease lease(context);
    try {
      return use((*function_)(*inputs(), lease.object()));
    } catch (py::error_already_set& raised) {
      if (raised.matches(py::module_::import("xgm._errors").attr("Cancelled"))) throw Cancelled();
      throw_as_error(raised, name_);
    }
  }

 private:
  Held function_;
  std::string name_;
};

class PythonFilter final : public Filter, PythonStage {
 public:
  using PythonStage::PythonStage;
  DisparityMap run(const DisparityMap& map, const ImagePair& pair,
                   const Context& context) const override {
    return call(
        context, [&] { return py::make_tuple(shown(map), shown(pair)); }, taken);
  }
};

class PythonMatcher final : public Matcher, PythonStage {
 public:
  using PythonStage::PythonStage;
  MatchResult run(const MatchRequest& request, const Context& context) const override {
    const Interval range = request.range.hull();
    return {call(
                context,
                [&] { return py::make_tuple(shown(request.pair), range.begin, range.end); }, taken),
            {}};
  }
  bool accepts_range_maps() const override { return false; }
};

/// S(d - 1), S(d) and S(d + 1) of each pixel, in units of a cost; NaN where there is none.
cv::Mat3f sums_around(const DisparityMap& map, const AggregatedVolume& sums) {
  const VolumeShape& shape = sums.shape();
  const float unit = std::ldexp(1.0F, -sums.fraction_bits);
  cv::Mat3f around(map.size(), cv::Vec3f::all(std::numeric_limits<float>::quiet_NaN()));
  for (int y = 0; y < shape.height(); ++y) {
    for (int x = 0; x < shape.width(); ++x) {
      if (!map.has_disparity(y, x)) continue;
      const int cell = static_cast<int>(std::lround(map.disparity(y, x))) - shape.begin(y, x);
      const auto cells = sums.cells(y, x);
      for (int i = 0; i < 3; ++i) {
        const int at = cell - 1 + i;
        if (at < 0 || at >= static_cast<int>(cells.size())) continue;
        const std::uint16_t sum = cells[static_cast<std::size_t>(at)];
        if (sum != AggregatedVolume::kNoMatch) around(y, x)[i] = static_cast<float>(sum) * unit;
      }
    }
  }
  return around;
}

class PythonRefinement final : public Refinement, PythonStage {
 public:
  using PythonStage::PythonStage;
  DisparityMap run(const DisparityMap& map, const AggregatedVolume& sums,
                   const Context& context) const override {
    const cv::Mat3f around = sums_around(map, sums);
    return call(
        context, [&] { return py::make_tuple(shown(map), to_array(around)); }, taken);
  }
};

/// Puts the costs of disparity d where pixels have a cell for it.
void put_costs(const cv::Mat1b& costs, int d, const Image& match, CostVolume& volume) {
  const VolumeShape& shape = volume.shape();
  for (int y = 0; y < shape.height(); ++y) {
    for (int x = 0; x < shape.width(); ++x) {
      const int cell = d - shape.begin(y, x);
      if (cell < 0 || cell >= shape.count(y, x)) continue;
      const int x_match = x - d;
      const bool can_match = x_match >= 0 && x_match < shape.width() && match.is_valid(y, x_match);
      volume.at(y, x)[cell] = can_match ? costs(y, x) : CostVolume::kNoMatch;
    }
  }
}

class PythonCost final : public Cost, PythonStage {
 public:
  using PythonStage::PythonStage;
  CostVolume run(const ImagePair& pair, const VolumeShapePtr& shape,
                 const Context& context) const override {
    const Interval hull = shape->hull();
    return call(
        context, [&] { return py::make_tuple(shown(pair), hull.begin, hull.end); },
        [&](const py::object& result) {
          // The bound, and an iterator that gives one array for each disparity.
          const auto [bound, slices] = result.cast<std::pair<int, py::object>>();
          CostVolume volume(shape, bound);
          int d = hull.begin;
          for (const py::handle& slice : slices) {
            const cv::Mat1b costs = to_mask(py::reinterpret_borrow<py::array>(slice));
            const py::gil_scoped_release release;
            put_costs(costs, d++, pair.match, volume);
          }
          return volume;
        });
  }
};

using Make = std::shared_ptr<const Stage> (*)(Held, std::string);

template <class T>
std::shared_ptr<const Stage> make(Held function, std::string name) {
  return std::make_shared<const T>(std::move(function), std::move(name));
}

const std::map<std::string, Make>& kinds() {
  static const std::map<std::string, Make> known{{"cost", &make<PythonCost>},
                                                 {"filter", &make<PythonFilter>},
                                                 {"matcher", &make<PythonMatcher>},
                                                 {"refinement", &make<PythonRefinement>}};
  return known;
}

}  // namespace

std::shared_ptr<const Stage> make_python_stage(const DeclaredStage& declared, Held function) {
  return kinds().at(declared.kind)(std::move(function), name_of(declared));
}

void require_python_kind(const std::string& kind) {
  if (kinds().contains(kind)) return;
  throw UsageError("stages of kind '" + kind +
                   "' cannot be written in Python; kinds that can: cost, filter, matcher, "
                   "refinement");
}

void bind_stages(py::module_& module) {
  StageContext::bind(module);
  py::class_<DeclaredParameter>(module, "Parameter")
      .def(py::init([](std::string name, std::string text, std::string unit, Value value,
                       std::optional<std::pair<double, double>> range, bool is_odd,
                       std::vector<std::string> choices, std::vector<std::size_t> elements) {
        return DeclaredParameter{
            std::move(name), std::move(text), std::move(unit),    std::move(value),
            range,           is_odd,          std::move(choices), std::move(elements)};
      }));
  module.def("add_stage",
             [](const std::string& kind, const std::string& name, const std::string& summary,
                const std::string& publication, const std::string& origin,
                std::vector<DeclaredParameter> parameters, py::object make) {
               registry().add(to_plugin({kind, name, summary, publication, origin,
                                         std::move(parameters), hold(std::move(make))}));
             });
  module.def("remove_stage", [](const std::string& kind, const std::string& name) {
    return registry().remove(kind, name);
  });
}

}  // namespace xgm::python
