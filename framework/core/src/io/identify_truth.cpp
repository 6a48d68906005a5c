// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/scene.hpp"

namespace xgm {

std::vector<InputFile> identify_truth(const TruthFiles& files) {
  std::vector<InputFile> inputs;
  for (const auto& [role, file] : {std::pair{"truth", files.disparity.file},
                                   {"reverse truth", files.reverse.file},
                                   {"truth of visible pixels", files.visible.file},
                                   {"truth mask", files.non_occluded},
                                   {"object map", files.objects}}) {
    if (!file.empty()) inputs.push_back({role, file, identify_file(file)});
  }
  return inputs;
}

}  // namespace xgm
