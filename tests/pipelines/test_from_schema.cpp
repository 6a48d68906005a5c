// SPDX-License-Identifier: Apache-2.0
// Any pipeline that the schema allows gives a sound map or an Error, the same for any threads.

#include "pipelines/from_schema.hpp"
#include "support/support.hpp"
#include "xgm/data/fault.hpp"
#include "xgm/pipeline/describe.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

constexpr int kPipelines = 300;

/// Pairs that are odd in one way each.
std::vector<MatchRequest> requests() {
  std::vector<MatchRequest> all;
  const auto add = [&](cv::Size size, Interval range, int channels) -> ImagePair& {
    all.push_back({shifted_pair(size, 2, all.size() + 1, channels),
                   DisparityRange::uniform(size, range), std::nullopt});
    return all.back().pair;
  };
  add({26, 17}, {0, 7}, 1);
  add({21, 14}, {-4, 5}, 3);
  ImagePair& masked = add({24, 15}, {0, 6}, 1);
  masked.base.valid = random_mask({24, 15}, 0.3, 1);
  masked.match.valid = random_mask({24, 15}, 0.3, 2);
  add({1, 19}, {0, 1}, 1);
  add({23, 1}, {0, 4}, 1);
  add({1, 1}, {0, 1}, 3);
  return all;
}

struct Ended {
  std::optional<MatchResult> maps;
  std::string error;
};

Ended run(const Pipeline& pipeline, const MatchRequest& request, int threads) {
  try {
    return {pipeline.run(request, {.threads = threads}), ""};
  } catch (const Error& error) {
    return {std::nullopt, error.what()};
  }
}

void check_ended(const Pipeline& pipeline, const MatchRequest& request) {
  const Ended one = run(pipeline, request, 1), two = run(pipeline, request, 2);
  CHECK(one.error == two.error);
  CHECK_MESSAGE(one.error.find("correct the plugin") == std::string::npos, one.error);
  if (!one.maps || !two.maps) return;
  CHECK(identical(one.maps->forward, two.maps->forward));
  const auto fault = fault_of(one.maps->forward, {request.pair.size(), request.range.hull()});
  CHECK_MESSAGE(!fault, (fault ? to_string(*fault) : ""));
  CHECK(one.maps->reverse.has_value() == two.maps->reverse.has_value());
  if (one.maps->reverse) CHECK(identical(*one.maps->reverse, *two.maps->reverse));
}

}  // namespace

TEST_CASE("any pipeline that the schema allows gives a sound map or an Error") {
  PipelineGenerator generator(pipeline_schema(builtins()), 1);
  const std::vector<MatchRequest> pairs = requests();
  int sound = 0;
  for (int i = 0; i < kPipelines; ++i) {
    const std::string text = generator.next();
    CAPTURE(text);
    const LoadedPipeline loaded = load_pipeline_text(text, "generated.yaml", builtins());
    if (!loaded.pipeline) continue;  // a relation between parameters does not hold
    ++sound;
    check_ended(*loaded.pipeline, pairs[static_cast<std::size_t>(i) % pairs.size()]);
  }
  CHECK(sound > kPipelines / 5);
}
