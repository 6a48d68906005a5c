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

struct KeptScope::Change {
  static RunState with(KeptResults* kept) {
    RunState state = run_state();
    state.kept = kept;
    return state;
  }
  explicit Change(KeptResults* kept) : run(with(kept)) {}
  RunChange run;
};

KeptScope::KeptScope(KeptResults* kept) : change_(std::make_unique<Change>(kept)) {}
KeptScope::~KeptScope() = default;

DisparityMap kept_part(KeptResults* kept, const std::string& name,
                       const std::function<DisparityMap(KeptResults*)>& make) {
  if (kept == nullptr) return make(nullptr);
  if (auto found = kept->find_part(name)) return std::move(*found);
  const std::shared_ptr<KeptResults> of_part = kept->of_part(name);
  DisparityMap map = make(of_part.get());
  kept->keep_part(name, map);
  return map;
}

}  // namespace xgm
