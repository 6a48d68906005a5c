// SPDX-License-Identifier: Apache-2.0
// Maps in tiles beside maps of the whole.
#include <doctest/doctest.h>

#include "support/support.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/data/crop.hpp"
#include "xgm/pipeline/lookup.hpp"
#include "xgm/plugin.hpp"
#include "xgm/synthesis/plain_scene.hpp"
#include "xgm/tiles/in_tiles.hpp"

using namespace xgm;
using namespace xgm::tiles;
using xgm::testing::builtins;
using xgm::testing::identical;

namespace {

synthesis::GeneratedScene generated(double shift = 0) {
  return synthesis::generate_plain(
      {.size = {261, 171}, .disparities = {-6, 34}, .seed = 3, .noise = 2, .shift = {.c = shift}});
}

DisparityMap in_tiles_of(const Pipeline& pipeline, const MatchRequest& request,
                         const TileOptions& tiles, const RunOptions& options = {}) {
  DisparityMap map(request.pair.size());
  run_in_tiles(
      pipeline, {std::make_shared<PairInMemory>(request.pair), request.range}, tiles,
      [&](const cv::Rect& place, const DisparityMap& part) {
        part.disparity.copyTo(map.disparity(place));
        part.status.copyTo(map.status(place));
      },
      options);
  return map;
}

/// Share of pixels of which one map alone has a disparity, or both have others by more than 1 px.
double different(const DisparityMap& a, const DisparityMap& b) {
  int count = 0;
  for (int y = 0; y < a.size().height; ++y) {
    for (int x = 0; x < a.size().width; ++x) {
      const bool both = a.has_disparity(y, x) && b.has_disparity(y, x);
      count += both ? std::abs(a.disparity(y, x) - b.disparity(y, x)) > 1
                    : a.has_disparity(y, x) != b.has_disparity(y, x);
    }
  }
  return count / static_cast<double>(a.size().area());
}

MatchRequest request_of(const synthesis::GeneratedScene& scene) {
  return {scene.pair, DisparityRange::uniform(scene.pair.size(), {-6, 34}), std::nullopt};
}

/// Does the same to a part as to the whole, and says nothing of that.
class Darker final : public Preprocess {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit Darker(Parameters) {}
  ImagePair run(const ImagePair& pair, const Context&) const override {
    ImagePair darker = pair;
    for (Image* image : {&darker.base, &darker.match}) {
      for (cv::Mat1f& plane : image->planes) plane = cv::Mat1f(plane * 0.5);
    }
    return darker;
  }
};

class Told final : public Observer {
 public:
  void stage_begin(const StagePlace& place) override { ++begun[place.path]; }
  void stage_end(const StagePlace& place, const StageStatistics& statistics,
                 const Artifact&) override {
    ++ended[place.path];
    seconds[place.path] = statistics.seconds;
  }
  void progress(double share) override {
    falls = falls || share < last;
    last = share;
  }
  std::map<std::string, int> begun, ended;
  std::map<std::string, double> seconds;
  double last = 0;
  bool falls = false;
};

}  // namespace

TEST_CASE("a map in tiles is that of the whole, within 1 px at 99.7 % of the pixels") {
  const MatchRequest request = request_of(generated(0.8));
  for (const std::string name : {"sgm8", "mgm16", "tsgm8", "tmgm16_refined"}) {
    CAPTURE(name);
    const Pipeline pipeline = require_pipeline(name, builtins());
    const DisparityMap whole = pipeline.run(request).forward;
    const DisparityMap tiled =
        in_tiles_of(pipeline, request, {.size = {128, 96}, .halo = 64, .coarse_pixels = 20000});
    MESSAGE(name << ": " << 100 * different(whole, tiled) << " % differ");
    CHECK(different(whole, tiled) <= 0.003);
  }
}

TEST_CASE("one tile that is the whole image gives the bytes of the whole") {
  const MatchRequest request = request_of(generated());
  for (const std::string name : {"sgm8", "mgm8"}) {
    const Pipeline pipeline = require_pipeline(name, builtins());
    CHECK(identical(in_tiles_of(pipeline, request, {.size = {400, 400}}),
                    pipeline.run(request).forward));
  }
  // What has no disparity in the coarse maps is searched for in less.
  const Pipeline pyramid = require_pipeline("tsgm8", builtins());
  const DisparityMap map = in_tiles_of(pyramid, request, {.size = {400, 400}});
  CHECK(different(map, pyramid.run(request).forward) < 1e-3);
}

TEST_CASE("stages that need no whole image prepare each tile by itself") {
  Registry registry = Registry::with_builtins();
  registry.add<Darker>("darker", "For this test.");
  const auto loaded = load_pipeline_text(
      "preprocess: [darker]\nmatcher: {type: semi_global, cost: absolute_difference, penalty: "
      "{type: constant, p1: 8, p2: 32}, aggregation: sgm}\n",
      "test.yaml", registry);
  REQUIRE(loaded.pipeline);
  const MatchRequest request = request_of(generated());
  const DisparityMap whole = loaded.pipeline->run(request).forward;
  CHECK(different(in_tiles_of(*loaded.pipeline, request, {.size = {128, 96}, .halo = 64}), whole) <=
        0.003);
  // Light counts: without the stage the map is another one.
  const Pipeline plain = *load_pipeline_text(
                              "matcher: {type: semi_global, cost: absolute_difference, penalty: "
                              "{type: constant, p1: 8, p2: 32}, aggregation: sgm}\n",
                              "test.yaml", registry)
                              .pipeline;
  CHECK(different(plain.run(request).forward, whole) > 0.003);
}

TEST_CASE("maps in tiles do not depend on the threads, and masked pixels have no disparity") {
  MatchRequest request = request_of(generated());
  request.pair.base.valid = cv::Mat1b(request.pair.size(), std::uint8_t{255});
  request.pair.base.valid(cv::Rect(90, 60, 60, 40)).setTo(0);
  const Pipeline pipeline = require_pipeline("tmgm16_refined", builtins());
  const TileOptions tiles{.size = {128, 96}, .halo = 32, .coarse_pixels = 3000};
  const DisparityMap one = in_tiles_of(pipeline, request, tiles, {.threads = 1});
  CHECK(identical(one, in_tiles_of(pipeline, request, tiles, {.threads = 3})));
  TileOptions keeping = tiles;
  keeping.keeps_memory = true;
  CHECK(identical(one, in_tiles_of(pipeline, request, keeping)));
  for (int y = 60; y < 100; ++y) {
    for (int x = 90; x < 150; ++x) CHECK_FALSE(one.has_disparity(y, x));
  }
}

TEST_CASE("ranges of pixels, and matchers that take none, work in tiles") {
  MatchRequest request = request_of(generated());
  const Pipeline sgbm = require_pipeline("opencv_sgbm", builtins());
  CHECK(in_tiles_of(sgbm, request, {.size = {128, 96}, .halo = 64}).density() > 0.7);
  request.range = DisparityRange::of_pixels(request.pair.size(), [](int, int x) {
    return x < 100 ? Interval{} : Interval{0, 30};
  });
  const Pipeline pipeline = require_pipeline("tsgm8", builtins());
  const DisparityMap map = in_tiles_of(pipeline, request, {.size = {128, 96}, .halo = 64});
  CHECK(cv::countNonZero(map.status.colRange(0, 90) == 0) == 0);
  CHECK(different(map, pipeline.run(request).forward) <= 0.003);
}

TEST_CASE("a run in tiles looks like one run to its observer, and can be cancelled") {
  const MatchRequest request = request_of(generated());
  const Pipeline pipeline = require_pipeline("tsgm8", builtins());
  Told told;
  in_tiles_of(pipeline, request, {.size = {128, 96}}, {.observer = &told});
  CHECK_FALSE(told.falls);
  CHECK(told.last > 0.99);
  CHECK(told.begun == told.ended);
  for (const auto& [path, count] : told.begun) CHECK(count == 1);
  CHECK(told.seconds.at("matcher.s1.matcher") > 0);
  std::stop_source stop;
  stop.request_stop();
  CHECK_THROWS_AS(in_tiles_of(pipeline, request, {}, {.stop = stop.get_token()}), Cancelled);
}

#ifndef XGM_SANITIZED  // sanitizers need memory of their own
TEST_CASE("tiles are as large as the memory allows") {
  const TiledRequest request{
      std::make_shared<PairInMemory>(xgm::testing::shifted_pair({1600, 1200}, 3, 1)),
      DisparityRange::uniform({1600, 1200}, {0, 128})};
  const Pipeline pipeline = require_pipeline("sgm8", builtins());
  const double base = static_cast<double>(resident_memory());
  const TileOptions large = fitting_tiles(pipeline, request, {}, base + 4e9, {});
  const TileOptions small = fitting_tiles(pipeline, request, {}, base + 3e8, {});
  CHECK(large.size.width >= 1600);
  CHECK(small.size.width < 1600);
  CHECK_THROWS_WITH_AS(fitting_tiles(pipeline, request, {.held = 1e9}, base, {}),
                       doctest::Contains("raise --memory-limit"), UsageError);
}

TEST_CASE("memory is kept from tile to tile unless filters afterwards take as much") {
  const TiledRequest request{
      std::make_shared<PairInMemory>(xgm::testing::shifted_pair({1600, 1200}, 3, 1)),
      DisparityRange::uniform({1600, 1200}, {0, 128})};
  const double limit = static_cast<double>(resident_memory()) + 3e8;
  const auto keeps = [&](const std::string& pipeline) {
    return fitting_tiles(require_pipeline(pipeline, builtins()), request, {}, limit, {})
        .keeps_memory;
  };
  CHECK(keeps("sgm8"));
  CHECK(keeps("tmgm16_refined"));
  CHECK_FALSE(keeps("tmgm16_best"));  // plane_filling
}
#endif
