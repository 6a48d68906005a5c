// SPDX-License-Identifier: Apache-2.0
// What a program includes that embeds xgm: load and check a pipeline, run a scene.
#pragma once

#include "xgm/pipeline/lookup.hpp"
#include "xgm/pipeline/pipeline.hpp"
