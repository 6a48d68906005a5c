// SPDX-License-Identifier: Apache-2.0
// Runs that go on from what another one has found, beside runs that do everything.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "support/paths.hpp"
#include "support/support.hpp"
#include "xgm/pipeline/lookup.hpp"
#include "xgm/pipeline/question.hpp"
#include "xgm/stage/kept_results.hpp"
#include "xgm/synthesis/plain_scene.hpp"
#include "xgm/tiles/tiled_run.hpp"

using namespace xgm;
using xgm::testing::builtins;
using xgm::testing::identical;

namespace {

struct InMemory final : KeptResults {
  std::optional<MatchResult> find(const std::string& name) override {
    const auto found = results.find(name);
    return found == results.end() ? std::nullopt : std::optional(found->second);
  }
  void keep(const std::string& name, const MatchResult& result) override {
    CHECK(results.emplace(name, result).second);
    names.push_back(name);
  }
  std::optional<DisparityMap> find_part(const std::string& name) override {
    const auto found = parts.find(name);
    return found == parts.end() ? std::nullopt : std::optional(found->second);
  }
  void keep_part(const std::string& name, const DisparityMap& part) override {
    CHECK(parts.emplace(name, part).second);
  }
  std::map<std::string, MatchResult> results{};
  std::vector<std::string> names{};
  std::map<std::string, DisparityMap> parts{};
};

struct Begun final : Observer {
  void stage_begin(const StagePlace& place) override { paths.push_back(place.path); }
  std::vector<std::string> paths{};
  bool has(const std::string& path) const {
    return std::find(paths.begin(), paths.end(), path) != paths.end();
  }
};

MatchRequest request() {
  const auto scene = synthesis::generate_plain(
      {.size = {133, 91}, .disparities = {-6, 34}, .seed = 3, .noise = 2});
  return {scene.pair, DisparityRange::uniform(scene.pair.size(), {-6, 34}), std::nullopt};
}

Pipeline shipped(const std::string& name) {
  return require_pipeline(XGM_SOURCE_DIR "/pipelines/" + name + ".yaml", builtins());
}

void check_same(const MatchResult& a, const MatchResult& b) {
  CHECK(identical(a.forward, b.forward));
  REQUIRE(a.reverse.has_value() == b.reverse.has_value());
  if (a.reverse) CHECK(identical(*a.reverse, *b.reverse));
}

DisparityMap in_tiles(const Pipeline& pipeline, KeptResults* kept) {
  const MatchRequest whole = request();
  DisparityMap map(whole.pair.size());
  tiles::run_in_tiles(pipeline, {std::make_shared<PairInMemory>(whole.pair), whole.range},
                      {.size = {64, 64}, .halo = 16, .coarse_pixels = 4000},
                      [&](const cv::Rect& place, const DisparityMap& part) {
                        part.disparity.copyTo(map.disparity(place));
                        part.status.copyTo(map.status(place));
                      },
                      {.kept = kept});
  return map;
}

}  // namespace

TEST_CASE("a run keeps its levels and what its matcher found, and goes on from any of them") {
  const Pipeline pipeline = shipped("tmgm16_refined");
  const MatchResult all = pipeline.run(request());
  InMemory kept;
  check_same(pipeline.run(request(), {.kept = &kept}), all);
  const std::vector<std::string> names{"matcher.s8", "matcher.s4", "matcher.s2", "matcher"};
  CHECK(kept.names == names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    CAPTURE(names[i]);
    InMemory some;
    for (std::size_t k = 0; k <= i; ++k) some.results.emplace(names[k], kept.results.at(names[k]));
    Begun begun;
    check_same(pipeline.run(request(), {.observer = &begun, .kept = &some}), all);
    CHECK(some.names ==
          std::vector<std::string>(names.begin() + std::ptrdiff_t(i) + 1, names.end()));
    CHECK_FALSE(begun.has("matcher.s8.matcher"));
    CHECK(begun.has("matcher.s1.matcher") == (names[i] != "matcher"));
  }
}

TEST_CASE(
    "levels of a pyramid inside of another matcher are not kept: their names tell too little") {
  const LoadedPipeline loaded = load_pipeline_text(
      "matcher: {type: left_right, matcher: {type: pyramid, scale: 4, matcher: {type: semi_global, "
      "cost: census, penalty: constant, aggregation: {type: sgm, directions: 4}}}}\n",
      "nested", builtins());
  REQUIRE(loaded.pipeline.has_value());
  InMemory kept;
  const MatchResult result = loaded.pipeline->run(request(), {.kept = &kept});
  CHECK(kept.names == std::vector<std::string>{"matcher"});
  check_same(result, loaded.pipeline->run(request()));
}

TEST_CASE("a run in tiles keeps the coarse levels and its parts, and does what is missing") {
  for (const char* name : {"tsgm8", "sgm8"}) {
    CAPTURE(std::string(name));
    const Pipeline pipeline = shipped(name);
    const DisparityMap all = in_tiles(pipeline, nullptr);
    InMemory kept;
    CHECK(identical(in_tiles(pipeline, &kept), all));
    CHECK(kept.parts.size() == 6);
    CHECK(kept.results.size() == (std::string(name) == "tsgm8" ? 1 : 0));
    kept.parts.erase(std::next(kept.parts.begin(), 2));
    kept.parts.erase(kept.parts.begin());
    CHECK(identical(in_tiles(pipeline, &kept), all));
    CHECK(kept.parts.size() == 6);
  }
}

TEST_CASE("a part is made once, with what is kept of it in force, and then found") {
  struct OfParts : KeptResults {
    explicit OfParts(KeptResults& of_part) : part(of_part) {}
    std::optional<MatchResult> find(const std::string&) override { return std::nullopt; }
    void keep(const std::string&, const MatchResult&) override {}
    std::shared_ptr<KeptResults> of_part(const std::string&) override {
      return {std::shared_ptr<KeptResults>(), &part};
    }
    KeptResults& part;
  };
  InMemory kept;
  OfParts of_parts(kept);
  DisparityMap map({3, 2});
  map.set(1, 2, 5);
  KeptResults* seen = nullptr;
  int made = 0;
  const auto make = [&](KeptResults* of_part) {
    const KeptScope scope(of_part);
    seen = kept_results();
    ++made;
    return map;
  };
  CHECK(identical(kept_part(nullptr, "a", make), map));
  CHECK(seen == nullptr);
  CHECK(identical(kept_part(&of_parts, "a", make), map));
  CHECK(seen == &kept);
  CHECK(kept_results() == nullptr);
  CHECK(identical(kept_part(&kept, "a", make), map));
  CHECK(identical(kept_part(&kept, "a", make), map));
  CHECK(made == 3);
}

TEST_CASE("the hash of a request is that of its pixels and ranges, wherever they lie") {
  const auto changed = [](const std::function<void(MatchRequest&)>& change) {
    MatchRequest some = request();
    some.pair.base.planes[0] = some.pair.base.planes[0].clone();
    some.pair.match.valid = cv::Mat1b(some.pair.size(), 255);
    change(some);
    return hash_of(some);
  };
  const std::string same = changed([](MatchRequest&) {});
  CHECK(changed([](MatchRequest& some) {
          cv::Mat1f wide(some.pair.size() + cv::Size(9, 0));
          cv::Mat1f part = wide.colRange(0, some.pair.size().width);
          some.pair.base.planes[0].copyTo(part);
          some.pair.base.planes[0] = part;
        }) == same);
  const std::vector<std::function<void(MatchRequest&)>> changes{
      [](MatchRequest& some) { some.pair.base.planes[0](90, 132) += 1; },
      [](MatchRequest& some) { some.pair.match.valid(0, 0) = 0; },
      [](MatchRequest& some) { some.pair.match.valid.release(); },
      [](MatchRequest& some) { std::swap(some.pair.base.planes, some.pair.match.planes); },
      [](MatchRequest& some) { some.pair.is_reverse = true; },
      [](MatchRequest& some) { some.reverse_range = some.range.reversed(); },
      [](MatchRequest& some) {
        some.range = DisparityRange::of_pixels(some.range.size(), [](int y, int x) {
          return Interval{-6, y == 7 && x == 9 ? 33 : 34};
        });
      }};
  std::set<std::string> hashes{same};
  for (const auto& change : changes) CHECK(hashes.insert(changed(change)).second);
}
