// SPDX-License-Identifier: Apache-2.0
// A folder with a flat pipeline and a scene, whose disparity is the same everywhere.
#pragma once

#include <string>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm::testing {

struct SmallScene : TemporaryFolder {
  explicit SmallScene(cv::Size size = {40, 24}) {
    constexpr int kDisparity = 3;
    write("p.yaml",
          "xgm: 1\n"
          "disparities: [0, 7]\n"
          "matcher:\n"
          "  type: semi_global\n"
          "  cost: {type: census, window: 5}\n"
          "  penalty: {type: constant, p1: 4, p2: 20}\n"
          "  aggregation: {type: sgm, directions: 4}\n");
    std::filesystem::create_directory(*this / "scene");
    const ImagePair pair = shifted_pair(size, kDisparity, 5);
    write_png(*this / "scene/im0.png", picture(pair.base));
    write_png(*this / "scene/im1.png", picture(pair.match));
    write_pfm(*this / "scene/disp0GT.pfm", cv::Mat1f(size, static_cast<float>(kDisparity)));
    write("scene/calib.txt",
          "cam0=[36 0 20; 0 36 12; 0 0 1]\ncam1=[36 0 20; 0 36 12; 0 0 1]\ndoffs=0\n"
          "baseline=160\nndisp=8\n");
  }
  Outcome call(const std::string& arguments, const std::string& before = {}) const {
    return pipeline(path(), arguments, before);
  }
};

}  // namespace xgm::testing
