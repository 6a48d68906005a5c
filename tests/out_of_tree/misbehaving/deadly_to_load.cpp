// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <xgm/plugin.hpp>

XGM_PLUGIN(registry) {
  if (!registry.kinds().empty()) std::abort();
}
