// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/image/kept_window.hpp"

#include "xgm/pipeline/question.hpp"
#include "xgm/stage/kept_results.hpp"

namespace xgm::geo {

DisparityMap kept_window(const MatchRequest& request, const Context& context,
                         const std::function<DisparityMap()>& match) {
  KeptResults* const kept = kept_results();
  if (kept == nullptr) return match();
  return kept_part(kept, context.path() + " of " + hash_of(request), [&](KeptResults* of_part) {
    const KeptScope scope(of_part);
    return match();
  });
}

}  // namespace xgm::geo
