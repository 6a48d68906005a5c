// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/ground/height_field.hpp"

namespace xgm::geo {

HeightField::~HeightField() = default;

}  // namespace xgm::geo
