// SPDX-License-Identifier: Apache-2.0
// Where key points are looked for: for the heights of a window, and all over a pair.
#include <algorithm>

#include "geo/cameras.hpp"
#include "geo/generated.hpp"
#include "geo/recorder.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/image/keypoints.hpp"
#include "xgm/geo/stage/pointing.hpp"
#include "xgm/geo/stage/range_prior.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::geo_stage;
using xgm::testing::Recorder;
using xgm::testing::TemporaryFolder;
using xgm::testing::written_images;

namespace {

constexpr int kSize = 400;

struct Mountains {
  Mountains() {
    SatelliteSceneSpec spec;
    spec.seed = 4;
    spec.size = kSize;
    spec.gsd = spec.posting = 1;
    spec.relief = 300;
    spec.views = {{.azimuth = 12, .incidence = 10, .heading = 188, .pointing_error = {}},
                  {.azimuth = 195, .incidence = 12, .heading = 193, .pointing_error = {}}};
    scene = make_satellite_scene(spec);
    images = written_images(folder / "scene", scene);
  }
  HeightInterval bounds(const std::string& yaml, const cv::Rect& window, Recorder& told) const {
    return geo_stage<RangePrior>(yaml)->heights(images[0], images[1], window, nullptr,
                                                Context(&told));
  }
  HeightInterval whole() const { return common_heights(images[0].camera, images[1].camera); }

  const TemporaryFolder folder;
  SatelliteScene scene;
  std::vector<SatelliteImage> images;
};

double width(const HeightInterval& heights) { return heights.max - heights.min; }

}  // namespace

TEST_CASE("a window with few key points is bounded by those around it, and keeps its truth") {
  const Mountains ground;
  const cv::Mat1f& heights = ground.scene.heights[0];
  for (const cv::Point corner : {cv::Point(180, 180), cv::Point(0, 0), cv::Point(370, 20)}) {
    const cv::Rect window(corner, cv::Size(30, 30));
    CAPTURE(window);
    Recorder told;
    const HeightInterval found = ground.bounds("keypoints", window, told);
    CHECK(told.warnings.empty());
    CHECK(told.figures.at("surroundings_px") >= 60);
    CHECK(told.figures.at("keypoints") >= 50);
    double low = 0, high = 0;
    cv::minMaxLoc(heights(window), &low, &high);
    CHECK(found.min <= low);
    CHECK(found.max >= high);
    CHECK(width(found) < width(ground.whole()));
    Recorder alone;
    const HeightInterval all = ground.bounds("{type: keypoints, surroundings: 0}", window, alone);
    CHECK(width(all) == width(ground.whole()));
    CHECK(alone.warned("key points match; the heights of the cameras are searched"));
  }
}

TEST_CASE("a window with key points enough is bounded by them alone") {
  const Mountains ground;
  const cv::Rect window(60, 60, 280, 280);
  Recorder told, alone;
  const HeightInterval found = ground.bounds("keypoints", window, told);
  const HeightInterval before = ground.bounds("{type: keypoints, surroundings: 0}", window, alone);
  CHECK(found.min == before.min);
  CHECK(found.max == before.max);
  CHECK_FALSE(told.figures.contains("surroundings_px"));
  // Where the image as a whole has too few, no more than all heights can be searched.
  Recorder few;
  const HeightInterval all = ground.bounds("{type: keypoints, min_matches: 100000}", window, few);
  CHECK(width(all) == width(ground.whole()));
  CHECK(few.figures.at("surroundings_px") == kSize);
  CHECK(few.warned("key points match"));
}

TEST_CASE("pointing looks at no key point twice where an image is little larger than a window") {
  const Mountains ground;
  const auto matches = [&](int window) {
    Recorder told;
    geo_stage<Pointing>("{type: keypoints, window: " + std::to_string(window) + "}")
        ->run(ground.images, {{0, 1}}, GroundKnowledge{nullptr, ground.whole()}, Context(&told));
    return told.figures.at("image_1 image_2 matches");
  };
  const auto in = [&](const cv::Rect& window) {
    return static_cast<double>(
        match_keypoints(ground.images[0], ground.images[1], window, ground.whole(), 20).size());
  };
  CHECK(matches(400) == in({0, 0, 400, 400}));
  CHECK(matches(380) == in({10, 10, 380, 380}));
  CHECK(matches(200) == in({0, 0, 200, 200}) + in({200, 0, 200, 200}) + in({0, 200, 200, 200}) +
                            in({200, 200, 200, 200}));
}
