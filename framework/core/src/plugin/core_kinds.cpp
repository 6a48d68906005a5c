// SPDX-License-Identifier: Apache-2.0
#include "plugin/core_kinds.hpp"

#include "xgm/stage/aggregation.hpp"
#include "xgm/stage/confidence.hpp"
#include "xgm/stage/consistency.hpp"
#include "xgm/stage/cost.hpp"
#include "xgm/stage/dataset.hpp"
#include "xgm/stage/filter.hpp"
#include "xgm/stage/fuser.hpp"
#include "xgm/stage/matcher.hpp"
#include "xgm/stage/penalty.hpp"
#include "xgm/stage/pipeline.hpp"
#include "xgm/stage/preprocess.hpp"
#include "xgm/stage/refinement.hpp"
#include "xgm/stage/search_range.hpp"
#include "xgm/stage/selection.hpp"

namespace xgm {

void add_core_kinds(Registry& registry) {
  registry.add_kind<Dataset>();
  registry.add_kind<PipelineFamily>();
  registry.add_kind<Preprocess>();
  registry.add_kind<Matcher>();
  registry.add_kind<Fuser>();
  registry.add_kind<SearchRange>();
  registry.add_kind<Cost>();
  registry.add_kind<Penalty>();
  registry.add_kind<Aggregation>();
  registry.add_kind<Selection>();
  registry.add_kind<Refinement>();
  registry.add_kind<Filter>();
  registry.add_kind<Consistency>();
  registry.add_kind<Confidence>();
}

}  // namespace xgm
