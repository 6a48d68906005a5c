// SPDX-License-Identifier: Apache-2.0
#include "xgm/stage/kept_results.hpp"

#include "base/run_state.hpp"

namespace xgm {

KeptResults::~KeptResults() = default;
std::optional<DisparityMap> KeptResults::find_part(const std::string&) { return std::nullopt; }
void KeptResults::keep_part(const std::string&, const DisparityMap&) {}
std::shared_ptr<KeptResults> KeptResults::of_part(const std::string&) { return nullptr; }
Json KeptResults::decided(const std::string&, const std::function<Json()>& decide) {
  return decide();
}

KeptResults* kept_results() { return run_state().kept; }

}  // namespace xgm
