// SPDX-License-Identifier: Apache-2.0
// PROJ's objects, freed by themselves.
#pragma once

#include <proj.h>
#include <proj_experimental.h>

#include <memory>
#include <string>

namespace xgm::geo {

struct DestroyContext {
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
};
struct DestroyProj {
  void operator()(PJ* object) const { proj_destroy(object); }
};
struct DestroyList {
  void operator()(PJ_OBJ_LIST* list) const { proj_list_destroy(list); }
};
using ProjContext = std::unique_ptr<PJ_CONTEXT, DestroyContext>;
using Proj = std::unique_ptr<PJ, DestroyProj>;
using ProjList = std::unique_ptr<PJ_OBJ_LIST, DestroyList>;

/// Of one thread; says nothing on stderr, and never asks the network for grids.
ProjContext make_context();
/// Throws Error if the text is no CRS.
Proj make_crs(PJ_CONTEXT* context, const std::string& text);

}  // namespace xgm::geo
