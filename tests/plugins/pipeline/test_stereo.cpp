// SPDX-License-Identifier: Apache-2.0
// Which maps the pipelines of one image pair give.
#include <doctest/doctest.h>

#include <map>

#include "tests/plugins/maps.hpp"
#include "tests/support/support.hpp"
#include "xgm/pipeline.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

/// How often each plugin ran on each view.
struct Counter : Observer {
  std::map<std::pair<std::string, View>, int> runs;
  void stage_begin(const StagePlace& place) override { ++runs[{place.plugin, place.view}]; }
};

MatchResult run(const std::string& more, Counter& counter) {
  const Registry registry = Registry::with_builtins();
  const LoadedPipeline loaded = load_pipeline_text(
      "matcher:\n"
      "  type: left_right\n"
      "  matcher: {type: semi_global, cost: census, penalty: constant, aggregation: sgm}\n"
      "postprocess: [median]\n" +
          more,
      "test.yaml", registry);
  REQUIRE(loaded.pipeline.has_value());
  const cv::Size size(40, 30);
  return loaded.pipeline->run(
      {shifted_pair(size, 3, 1), DisparityRange::uniform(size, {0, 8}), std::nullopt},
      {.observer = &counter});
}

}  // namespace

TEST_CASE("stereo: views: left finishes the left map alone, and that one in the same way") {
  Counter of_both, of_left;
  const MatchResult both = run("", of_both), left = run("views: left\n", of_left);
  CHECK(both.reverse.has_value());
  CHECK_FALSE(left.reverse.has_value());
  CHECK(identical(both.forward, left.forward));
  CHECK(of_both.runs[{"median", View::reverse}] == 1);
  CHECK(of_left.runs[{"median", View::reverse}] == 0);
  CHECK(of_left.runs[{"median", View::forward}] == 1);
  // The check of both views against each other is none of its business.
  CHECK(of_left.runs[{"semi_global", View::reverse}] == 1);
}
