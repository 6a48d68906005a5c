// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <mutex>
#include <thread>
#include <unordered_map>

#include "ground/proj.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/ground/crs.hpp"

namespace xgm::geo {
namespace {

/// The grids that the best transformation between two CRS needs, and this machine lacks.
std::string missing_grids(PJ_CONTEXT* context, const PJ* from, const PJ* to) {
  PJ_OPERATION_FACTORY_CONTEXT* const factory =
      proj_create_operation_factory_context(context, nullptr);
  proj_operation_factory_context_set_grid_availability_use(context, factory,
                                                           PROJ_GRID_AVAILABILITY_IGNORED);
  const ProjList operations(proj_create_operations(context, from, to, factory));
  proj_operation_factory_context_destroy(factory);
  if (operations == nullptr || proj_list_get_count(operations.get()) == 0) return {};
  const Proj best(proj_list_get(context, operations.get(), 0));
  std::string missing;
  for (int i = 0; i < proj_coordoperation_get_grid_used_count(context, best.get()); ++i) {
    const char* name = nullptr;
    int available = 0;
    proj_coordoperation_get_grid_used(context, best.get(), i, &name, nullptr, nullptr, nullptr,
                                      nullptr, nullptr, &available);
    if (available == 0) missing += (missing.empty() ? "" : ", ") + std::string(name);
  }
  return missing;
}

Proj make_transform(PJ_CONTEXT* context, const Crs& from, const Crs& to) {
  const Proj source = make_crs(context, from), target = make_crs(context, to);
  const std::string what =
      std::string(proj_get_name(source.get())) + " to " + proj_get_name(target.get());
  const std::string missing = missing_grids(context, source.get(), target.get());
  if (!missing.empty()) {
    throw Error("heights cannot be taken from " + what + ": PROJ lacks the grid " + missing +
                "; install it (it belongs into PROJ's data folder), or give heights above egm96 or "
                "the ellipsoid");
  }
  const char* const options[] = {"ALLOW_BALLPARK=NO", nullptr};
  const Proj transform(
      proj_create_crs_to_crs_from_pj(context, source.get(), target.get(), nullptr, options));
  if (transform == nullptr) throw Error("PROJ knows no exact transformation from " + what);
  Proj east_first(proj_normalize_for_visualization(context, transform.get()));
  if (east_first == nullptr) throw Error("PROJ knows no exact transformation from " + what);
  return east_first;
}

}  // namespace

/// PROJ's objects belong to one thread at a time: each thread makes its own.
struct CrsTransform::Impl {
  struct OfThread {
    ProjContext context;
    Proj transform;
  };
  Crs from, to;
  std::mutex mutex;
  std::unordered_map<std::thread::id, OfThread> threads;

  PJ* mine() {
    const std::lock_guard lock(mutex);
    OfThread& own = threads[std::this_thread::get_id()];
    if (own.transform == nullptr) {
      own.context = make_context();
      own.transform = make_transform(own.context.get(), from, to);
    }
    return own.transform.get();
  }

  cv::Vec3d apply(PJ_DIRECTION direction, const cv::Vec3d& point) {
    PJ* const transform = mine();
    const PJ_COORD result =
        proj_trans(transform, direction, proj_coord(point[0], point[1], point[2], HUGE_VAL));
    if (!std::isfinite(result.xyzt.x)) {
      throw Error("(" + std::to_string(point[0]) + ", " + std::to_string(point[1]) +
                  ") lies outside of what PROJ can transform to " + crs_name(to));
    }
    return {result.xyzt.x, result.xyzt.y, result.xyzt.z};
  }
};

CrsTransform::CrsTransform(const Crs& from, const Crs& to) : impl_(std::make_unique<Impl>()) {
  impl_->from = from;
  impl_->to = to;
  impl_->mine();
}

CrsTransform::~CrsTransform() = default;

cv::Vec3d CrsTransform::forward(const cv::Vec3d& point) const {
  return impl_->apply(PJ_FWD, point);
}

cv::Vec3d CrsTransform::inverse(const cv::Vec3d& point) const {
  return impl_->apply(PJ_INV, point);
}

}  // namespace xgm::geo
