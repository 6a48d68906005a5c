// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/ground/crs.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "ground/proj.hpp"
#include "xgm/base/error.hpp"

namespace xgm::geo {
namespace {

std::string wkt(PJ_CONTEXT* context, const PJ* crs) {
  const char* const text = proj_as_wkt(context, crs, PJ_WKT2_2019, nullptr);
  if (text == nullptr) throw Error("PROJ cannot write a coordinate reference system as WKT");
  return text;
}

}  // namespace

ProjContext make_context() {
  ProjContext context(proj_context_create());
  proj_log_level(context.get(), PJ_LOG_NONE);
  proj_context_set_enable_network(context.get(), 0);
  return context;
}

Proj make_crs(PJ_CONTEXT* context, const std::string& text) {
  Proj crs(proj_create(context, text.c_str()));
  if (crs == nullptr || proj_is_crs(crs.get()) == 0) {
    throw Error("'" + text +
                "' is no coordinate reference system that PROJ knows; write a code such "
                "as EPSG:32740");
  }
  return crs;
}

Crs with_heights(const Crs& horizontal, const std::string& vertical_datum) {
  static const std::map<std::string, std::string> codes{
      {"egm96", "EPSG:5773"}, {"egm2008", "EPSG:3855"}, {"egm84", "EPSG:5798"}};
  std::string datum = vertical_datum;
  std::ranges::transform(datum, datum.begin(), [](unsigned char c) { return std::tolower(c); });
  const ProjContext context = make_context();
  const Proj base = make_crs(context.get(), horizontal);
  if (datum == "ellipsoid") {
    const Proj crs(proj_crs_promote_to_3D(context.get(), nullptr, base.get()));
    return wkt(context.get(), crs.get());
  }
  const auto code = codes.find(datum);
  if (code == codes.end() && !datum.starts_with("epsg:")) {
    throw UsageError("'" + vertical_datum +
                     "' is no vertical datum; write ellipsoid, egm96, egm2008, "
                     "egm84 or the code of a vertical CRS, such as EPSG:5773");
  }
  const Proj vertical =
      make_crs(context.get(), code != codes.end() ? code->second : vertical_datum);
  const Proj crs(
      proj_create_compound_crs(context.get(), "horizontal + height", base.get(), vertical.get()));
  if (crs == nullptr) throw UsageError("'" + vertical_datum + "' is no vertical datum");
  return wkt(context.get(), crs.get());
}

bool has_heights(const Crs& crs) {
  const ProjContext context = make_context();
  const Proj object = make_crs(context.get(), crs);
  if (proj_get_type(object.get()) == PJ_TYPE_COMPOUND_CRS) return true;
  const Proj system(proj_crs_get_coordinate_system(context.get(), object.get()));
  return system != nullptr && proj_cs_get_axis_count(context.get(), system.get()) == 3;
}

bool has_ellipsoidal_heights(const Crs& crs) {
  const ProjContext context = make_context();
  const Proj object = make_crs(context.get(), crs);
  return proj_get_type(object.get()) != PJ_TYPE_COMPOUND_CRS && has_heights(crs);
}

Crs horizontal(const Crs& crs) {
  const ProjContext context = make_context();
  const Proj object = make_crs(context.get(), crs);
  const bool is_compound = proj_get_type(object.get()) == PJ_TYPE_COMPOUND_CRS;
  const Proj flat(is_compound ? proj_crs_get_sub_crs(context.get(), object.get(), 0)
                              : proj_crs_demote_to_2D(context.get(), nullptr, object.get()));
  return wkt(context.get(), flat.get());
}

bool is_wgs84(const Crs& crs) {
  const ProjContext context = make_context();
  const Proj flat = make_crs(context.get(), horizontal(crs));
  const Proj wgs84 = make_crs(context.get(), "EPSG:4326");
  return proj_is_equivalent_to(flat.get(), wgs84.get(),
                               PJ_COMP_EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS) != 0;
}

bool is_projected(const Crs& crs) {
  const ProjContext context = make_context();
  const Proj flat = make_crs(context.get(), horizontal(crs));
  return proj_get_type(flat.get()) == PJ_TYPE_PROJECTED_CRS;
}

std::string crs_name(const Crs& crs) {
  const ProjContext context = make_context();
  return proj_get_name(make_crs(context.get(), crs).get());
}

std::optional<int> epsg_code(const Crs& crs) {
  const ProjContext context = make_context();
  const Proj flat = make_crs(context.get(), horizontal(crs));
  constexpr int kCertain = 100;  // %, that a CRS without a code is the one of EPSG
  int* confidence = nullptr;
  PJ_OBJ_LIST* const found = proj_identify(context.get(), flat.get(), "EPSG", nullptr, &confidence);
  std::optional<int> code;
  if (found != nullptr && proj_list_get_count(found) > 0 && confidence[0] == kCertain) {
    const Proj best(proj_list_get(context.get(), found, 0));
    code = std::stoi(proj_get_id_code(best.get(), 0));
  }
  proj_int_list_destroy(confidence);
  proj_list_destroy(found);
  return code;
}

std::string heights_name(const Crs& crs) {
  const ProjContext context = make_context();
  const Proj object = make_crs(context.get(), crs);
  if (proj_get_type(object.get()) != PJ_TYPE_COMPOUND_CRS) return std::string(kEllipsoidalHeights);
  return proj_get_name(Proj(proj_crs_get_sub_crs(context.get(), object.get(), 1)).get());
}

Crs utm_crs(double longitude, double latitude) {
  const int zone = std::clamp(static_cast<int>(std::floor((longitude + 180) / 6)) + 1, 1, 60);
  return "EPSG:" + std::to_string((latitude < 0 ? 32700 : 32600) + zone);
}

}  // namespace xgm::geo
