// SPDX-License-Identifier: Apache-2.0
// What a plugin includes: all kinds of stage, the registry and XGM_PLUGIN.
#pragma once

#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/config/parameters.hpp"
#include "xgm/plugin/handshake.hpp"
#include "xgm/plugin/registry.hpp"
#include "xgm/stage/aggregation.hpp"
#include "xgm/stage/confidence.hpp"
#include "xgm/stage/consistency.hpp"
#include "xgm/stage/cost.hpp"
#include "xgm/stage/dataset.hpp"
#include "xgm/stage/filter.hpp"
#include "xgm/stage/matcher.hpp"
#include "xgm/stage/needs.hpp"
#include "xgm/stage/penalty.hpp"
#include "xgm/stage/pipeline.hpp"
#include "xgm/stage/preprocess.hpp"
#include "xgm/stage/refinement.hpp"
#include "xgm/stage/search_range.hpp"
#include "xgm/stage/selection.hpp"
#include "xgm/stage/slot.hpp"
