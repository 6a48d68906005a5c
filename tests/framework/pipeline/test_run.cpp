// SPDX-License-Identifier: Apache-2.0
// Running a loaded pipeline: paths, observers, errors, refusals.
#include <doctest/doctest.h>

#include "support/fake_stages.hpp"
#include "support/support.hpp"

using namespace xgm;

namespace {

Pipeline load(const std::string& text) {
  static const Registry registry = xgm::testing::fake_registry();
  LoadedPipeline loaded = load_pipeline_text(text, "test.yaml", registry);
  REQUIRE(loaded.pipeline.has_value());
  return *loaded.pipeline;
}

MatchRequest request(cv::Size size = {4, 3}, Interval range = {-2, 3}) {
  return {xgm::testing::shifted_pair(size, 1, 1), DisparityRange::uniform(size, range),
          std::nullopt};
}

struct Recorder : Observer {
  std::vector<std::string> begun, ended;
  double last = 0;
  bool fell = false;
  void stage_begin(const StagePlace& place) override {
    begun.push_back(place.path + "=" + place.plugin);
  }
  void stage_end(const StagePlace& place, const StageStatistics&, const Artifact&) override {
    ended.push_back(place.path);
  }
  void progress(double share) override {
    fell = fell || share < last;
    last = share;
  }
};

std::string error_of(const Pipeline& pipeline, const MatchRequest& request) {
  Recorder recorder;
  try {
    pipeline.run(request, {.observer = &recorder});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the observer sees every stage by its path, and progress that ends at 1") {
  const Pipeline pipeline = load(
      "matcher: {type: fake_matcher, cost: fake_cost, filters: [fake_filter]}\n"
      "postprocess: [fake_filter, fake_filter]");
  Recorder recorder;
  const MatchResult result = pipeline.run(request(), {.observer = &recorder});
  CHECK(recorder.begun ==
        std::vector<std::string>{"matcher=fake_matcher", "matcher.filters[0]=fake_filter",
                                 "postprocess[0]=fake_filter", "postprocess[1]=fake_filter"});
  CHECK(recorder.ended == std::vector<std::string>{"matcher.filters[0]", "matcher",
                                                   "postprocess[0]", "postprocess[1]"});
  CHECK(recorder.last == 1);
  CHECK_FALSE(recorder.fell);
  CHECK(result.forward.disparity(2, 3) == -2);
}

TEST_CASE("an error carries the path of the stage that failed") {
  const Pipeline pipeline = load(
      "matcher: {type: fake_matcher, cost: fake_cost, filters: [fake_filter, failing_filter]}");
  CHECK(error_of(pipeline, request()) == "matcher.filters[1]: cannot go on; do something else");
}

TEST_CASE("a request that cannot be met is refused with the remedy") {
  const Pipeline pipeline = load("matcher: {type: fake_matcher, cost: fake_cost}");
  CHECK(error_of(pipeline, request({0, 0})).find("empty") != std::string::npos);
  CHECK(error_of(pipeline, request({4, 3}, {2, 2})).find("range is empty") != std::string::npos);

  MatchRequest other = request();
  other.pair.match = xgm::testing::random_image({5, 3}, 1);
  CHECK(error_of(pipeline, other).find("differ in size") != std::string::npos);

  MatchRequest maps = request();
  maps.range = DisparityRange(cv::Mat1i(3, 4, 0), cv::Mat1i(3, 4, 2));
  CHECK(error_of(pipeline, maps).find("one range for the whole image") != std::string::npos);
}
