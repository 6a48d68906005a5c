// SPDX-License-Identifier: Apache-2.0
// Our SGM and MGM agree with the maps of an independent program (gfacciol/mgm), which are kept in
// ../reference/mgm beside the test data with a README of their settings.
//
// The maps called 16 are no measure: that program knows eight directions. Its table of passes ends
// there ("22.5 degrees ..." is an empty comment), and asked for 16 it reads past the table's end
// (built with -D_GLIBCXX_ASSERTIONS it stops: "vector::operator[]: __n < this->size()"). What the
// passes 9 to 16 did is undefined, so for these maps the shares are printed, not judged.
#include <cmath>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "support/support.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

struct Scene {
  std::string name, folder;
  int disparities;
};

Image grey_image(const std::filesystem::path& file) {
  const cv::Mat colour = cv::imread(file.string(), cv::IMREAD_COLOR);
  REQUIRE_MESSAGE(!colour.empty(), "cannot read ", file.string());
  cv::Mat1b grey;
  cv::cvtColor(colour, grey, cv::COLOR_BGR2GRAY);
  cv::Mat1f plane;
  grey.convertTo(plane, CV_32F);
  return Image(plane);
}

std::string matcher_yaml(const std::string& aggregation, int directions) {
  return "{type: semi_global, cost: {type: census, window: 5}, penalty: {type: constant, p1: 8, "
         "p2: 32}, aggregation: {type: " +
         aggregation + ", directions: " + std::to_string(directions) +
         ", overcounting_correction: true}, selection: wta}";
}

/// Share of pixels within 1 px of the reference, of those that both maps match inside the image.
double agreement(const DisparityMap& ours, const cv::Mat1f& theirs) {
  int both = 0, agreeing = 0;
  for (int y = 0; y < theirs.rows; ++y) {
    for (int x = 0; x < theirs.cols; ++x) {
      const float d = ours.disparity(y, x), reference = theirs(y, x);
      const auto column = static_cast<float>(x);
      if (!(column - d >= 0) || !std::isfinite(reference) || column - reference < 0) continue;
      ++both;
      if (std::abs(d - reference) <= 1) ++agreeing;
    }
  }
  CHECK(both > 0.8 * static_cast<double>(theirs.total()));
  return static_cast<double>(agreeing) / both;
}

}  // namespace

TEST_CASE("at least 97 % of pixels agree within 1 px with an independent program, 8 directions") {
  const auto data = test_data("comparison with an independent program");
  if (!data) return;
  const std::vector<Scene> scenes{
      {"cones", "middlebury_v2/cones", 64},
      {"Motorcycle", "middlebury_v3_trainingQ/Motorcycle", 72},
      {"playground_1l", "eth3d_two_view_training/playground_1l", 32},
  };
  for (const Scene& scene : scenes) {
    const auto folder = *data / "stereo" / scene.folder;
    const ImagePair pair{grey_image(folder / "im0.png"), grey_image(folder / "im1.png")};
    const DisparityRange range = DisparityRange::uniform(pair.size(), {0, scene.disparities});
    for (const std::string aggregation : {"sgm", "mgm"}) {
      for (const int directions : {8, 16}) {
        const std::string name = scene.name + "_" + aggregation + std::to_string(directions);
        const cv::Mat1f theirs =
            read_pfm((*data / ".." / "reference" / "mgm" / (name + ".pfm")).string());
        REQUIRE(theirs.size() == pair.size());
        const DisparityMap ours = stage<Matcher>(matcher_yaml(aggregation, directions))
                                      ->run({pair, range, {}}, Context{})
                                      .forward;
        const double share = agreement(ours, theirs);
        std::cout << name << ": " << 100 * share << " % agree within 1 px" << std::endl;
        if (directions == 8) CHECK_MESSAGE(share >= 0.97, name);
      }
    }
  }
}
