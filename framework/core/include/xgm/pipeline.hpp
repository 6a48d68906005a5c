// SPDX-License-Identifier: Apache-2.0
// What a program includes that embeds xgm: load and check a pipeline, run it on a scene or on
// images in memory, write what it found. docs/use_from_cpp.md shows how.
#pragma once

#include "xgm/base/error.hpp"
#include "xgm/io/write_maps.hpp"
#include "xgm/pipeline/depth_files.hpp"
#include "xgm/pipeline/installation.hpp"
#include "xgm/pipeline/lookup.hpp"
#include "xgm/pipeline/pipeline.hpp"
#include "xgm/pipeline/scene_inputs.hpp"
#include "xgm/pipeline/scene_run.hpp"
#include "xgm/stage/observers.hpp"
