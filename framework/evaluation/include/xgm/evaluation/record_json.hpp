// SPDX-License-Identifier: Apache-2.0
// Parts of run.json that records of every family have.
#pragma once

#include "xgm/base/json.hpp"
#include "xgm/evaluation/run_record.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {

XGM_API Json to_json(const std::vector<InputFile>& inputs);
XGM_API Json to_json(const std::vector<OutputFile>& outputs);
XGM_API Json to_json(const std::vector<StageRecord>& stages);
XGM_API Json to_json(const std::vector<Override>& overrides);
/// Results of earlier runs: the folder they are from, and their names.
XGM_API Json reused_json(const std::string& folder, const std::vector<std::string>& results);
/// Of xgm, OpenCV, the compiler, and the build that plugins must share.
XGM_API Json versions_json();

}  // namespace xgm
