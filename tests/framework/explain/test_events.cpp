// SPDX-License-Identifier: Apache-2.0
// The events name the stage that changed a pixel, and end with what the run returned.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "framework/explain/explained.hpp"
#include "support/paths.hpp"
#include "support/temporary_folder.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

std::string left_right(const std::string& selection, const std::string& filters) {
  return "matcher: {type: left_right, matcher: {type: semi_global, cost: census, penalty: {type: "
         "constant, p1: 24, p2: 96}, aggregation: {type: sgm, directions: 4}, selection: " +
         selection + ", refinement: parabola, filters: " + filters + "}}\n";
}

const std::string kPlain = left_right("wta", "[]");

/// What the last event of the base view at full size left behind.
const ExplainedEvent* last_event(const Explanation& explanation) {
  const auto& events = explanation.events;
  const auto found = std::find_if(events.rbegin(), events.rend(), [](const ExplainedEvent& event) {
    return !event.reverse && event.level.scale == 1 && event.after;
  });
  return found == events.rend() ? nullptr : &*found;
}

/// All pixels: the story ends with the map, and every event begins where the one before ended.
void check_story(const Explained& explained) {
  for (const Explanation& pixel : explained.pixels) {
    CAPTURE(pixel.pixel.x);
    CAPTURE(pixel.pixel.y);
    const PixelState is = state_at(explained.result.forward, pixel.pixel.y, pixel.pixel.x);
    const ExplainedEvent* last = last_event(pixel);
    REQUIRE(last != nullptr);
    REQUIRE(*last->after == is);
    REQUIRE(pixel.result == is);
    std::optional<PixelState> state;
    for (const ExplainedEvent& event : pixel.events) {
      if (event.reverse || event.level.scale != 1 || !event.after) continue;
      if (event.before && state) REQUIRE(*event.before == *state);
      state = event.after;
    }
    REQUIRE_FALSE(pixel.verdict.empty());
  }
}

/// The only event that ended at this status is of this stage and had this effect.
int check_cause(const Explained& explained, Status status, const std::string& stage,
                const std::string& plugin, Effect effect) {
  int count = 0;
  for (const Explanation& pixel : explained.pixels) {
    if (pixel.result.status != status) continue;
    ++count;
    int causes = 0;
    for (const ExplainedEvent& event : pixel.events) {
      if (event.reverse || !event.after || event.effect == Effect::kept) continue;
      if (event.after->status != status) continue;
      ++causes;
      REQUIRE(event.place.path == stage);
      REQUIRE(event.place.plugin == plugin);
      REQUIRE(event.effect == effect);
      REQUIRE(contains(pixel.verdict, plugin));
    }
    REQUIRE(causes == 1);
  }
  return count;
}

/// Runs the matcher inside twice, and then adds to the disparities behind everyone's back.
class Meddler final : public Matcher {
 public:
  explicit Meddler(std::shared_ptr<const Matcher> inner) : inner_(std::move(inner)) {}
  MatchResult run(const MatchRequest& request, const Context& context) const override {
    const Interval hull = request.range.hull();  // that what is added to stays in
    const MatchRequest inside{
        request.pair, DisparityRange::uniform(request.pair.size(), {hull.begin, hull.end - 1}),
        std::nullopt};
    inner_(context.scope("first"), inside);
    MatchResult result = inner_(context.scope("second"), inside);
    result.forward = result.forward.clone();
    for (float& disparity : result.forward.disparity) disparity += 1;
    return result;
  }

 private:
  Slot<Matcher> inner_;
};

bool is_same_curve(const std::vector<float>& a, const std::vector<float>& b) {
  return !a.empty() && std::ranges::equal(a, b, [](float x, float y) {
    return x == y || (std::isnan(x) && std::isnan(y));
  });
}

}  // namespace

TEST_CASE(
    "for every pixel of every shipped pipeline the story ends with the map that is returned") {
  const SyntheticScene scene = small_scene();
  const DisparityRange range = DisparityRange::uniform(scene.pair.size(), scene.disparities);
  int pipelines = 0;
  for (const auto& entry : std::filesystem::directory_iterator(XGM_SOURCE_DIR "/pipelines")) {
    if (!entry.is_regular_file()) continue;
    CAPTURE(entry.path().string());
    const LoadedPipeline pipeline = load_pipeline(entry.path().string(), builtins());
    REQUIRE(pipeline.pipeline.has_value());
    check_story(explain_all(*pipeline.pipeline, scene.pair, range, scene.truth));
    ++pipelines;
  }
  CHECK(pipelines >= 11);
}

TEST_CASE("the story ends with the map for one pixel, one row, masks and negative ranges too") {
  const std::string yaml = "matcher: {type: pyramid, scale: 4, " +
                           kPlain.substr(0, kPlain.size() - 1) +
                           "}\npostprocess: [discontinuity_preserving_interpolation]\n";
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(9, 1), cv::Size(1, 7), cv::Size(23, 13)}) {
    CAPTURE(size.width);
    ImagePair pair = shifted_pair(size, 0, 7);
    pair.base.valid = random_mask(size, 0.3, 8);
    pair.match.valid = random_mask(size, 0.2, 9);
    const DisparityRange range = DisparityRange::uniform(size, {-3, 2});
    check_story(explain_all(loaded(yaml), pair, range));
  }
}

TEST_CASE("what the consistency check kills is told as its deed, with what the other view says") {
  const Explained explained = explain_all(kPlain, small_scene());
  for (const Status status : {Status::occluded, Status::mismatched}) {
    CHECK(check_cause(explained, status, "matcher.consistency", "lrrl", Effect::killed) > 0);
  }
  for (const Explanation& pixel : explained.pixels) {
    if (pixel.result.status != Status::occluded) continue;
    CHECK(pixel.verdict == "killed by consistency lrrl at full scale: occluded");
    const ExplainedEvent* last = last_event(pixel);
    CHECK(contains(last->text, "reverse view at x = "));
    const auto& reverse = pixel.levels.front().reverse;
    if (reverse) CHECK(contains(last->text, "x = " + std::to_string(reverse->pixel.x) + " "));
  }
}

TEST_CASE("the reverse view is shown where the forward disparity points at") {
  const Explained explained = explain_all(left_right("wta", "[]"), small_scene());
  int shown = 0;
  for (const Explanation& pixel : explained.pixels) {
    const LevelExplanation& level = pixel.levels.front();
    const float d =
        static_cast<float>(level.forward.winner->disparity) + level.forward.shift.value_or(0.F);
    const int there = static_cast<int>(std::floor(float(pixel.pixel.x) - d + 0.5F));
    REQUIRE(level.reverse.has_value() ==
            (0 <= there && there < explained.result.forward.size().width));
    if (!level.reverse) continue;
    ++shown;
    REQUIRE(level.reverse->pixel == cv::Point(there, pixel.pixel.y));
    REQUIRE(level.reverse->range == Interval{-11, 1});
    REQUIRE(level.reverse->result == state_at(*explained.result.reverse, pixel.pixel.y, there));
  }
  CHECK(shown > 1000);
}

TEST_CASE("peak removal, uniqueness, masks and ranges are named as the causes that they are") {
  const SyntheticScene scene = small_scene();
  const auto single = [&](const std::string& selection, const std::string& filters) {
    std::string yaml = left_right(selection, filters);
    const std::string whole = "matcher: {type: left_right, matcher: ";
    return "matcher: " + yaml.substr(whole.size(), yaml.rfind('}') - whole.size());
  };
  SUBCASE("peak") {
    const Explained explained =
        explain_all(single("wta", "[{type: median, window: 3}, peak_removal]"), scene);
    CHECK(check_cause(explained, Status::peak, "matcher.filters[1]", "peak_removal",
                      Effect::killed) > 0);
  }
  SUBCASE("ambiguous") {
    const Explained explained = explain_all(single("{type: wta, uniqueness: 60}", "[]"), scene);
    CHECK(check_cause(explained, Status::ambiguous, "matcher.selection", "wta", Effect::unmatched) >
          0);
    for (const Explanation& pixel : explained.pixels) {
      if (pixel.result.status != Status::ambiguous) continue;
      CHECK(pixel.levels.front().forward.winner.has_value());
    }
  }
  SUBCASE("masked") {
    SyntheticScene masked = scene;
    masked.pair.base.valid = random_mask(scene.pair.size(), 0.1, 4);
    const Explained explained = explain_all(single("wta", "[]"), masked);
    CHECK(check_cause(explained, Status::masked, "matcher", "semi_global", Effect::relabelled) > 0);
  }
  SUBCASE("out of range") {
    SyntheticScene narrow = scene;
    narrow.disparities = {5, 12};
    const Explained explained = explain_all(single("wta", "[]"), narrow);
    CHECK(check_cause(explained, Status::out_of_range, "matcher.selection", "wta",
                      Effect::unmatched) >= 5 * 43);
    const auto& events = explained.at(3, 2).events;
    CHECK(std::any_of(events.begin(), events.end(), [](const ExplainedEvent& event) {
      return contains(event.text, "nothing of 5 to 11 can be matched");
    }));
  }
  SUBCASE("filled") {
    const Explained explained =
        explain_all(kPlain + "postprocess: [discontinuity_preserving_interpolation]\n", scene);
    CHECK(check_cause(explained, Status::filled, "postprocess[0]",
                      "discontinuity_preserving_interpolation", Effect::filled) > 0);
    for (const Explanation& pixel : explained.pixels) {
      if (pixel.result.status == Status::filled) {
        CHECK(contains(pixel.verdict, "; before that "));
        CHECK(contains(pixel.verdict, "consistency lrrl"));
      }
    }
  }
}

TEST_CASE("matchers that show no volumes are explained by what they return") {
  const SyntheticScene scene = small_scene();
  const Explained explained =
      explain_all("matcher: {type: left_right, matcher: opencv_sgbm}", scene);
  check_story(explained);
  for (const Explanation& pixel : explained.pixels) {
    REQUIRE(pixel.levels.size() == 1);
    const MatchExplanation& match = pixel.levels.front().forward;
    CHECK(match.plugin == "opencv_sgbm");
    CHECK(match.costs.empty());
    CHECK_FALSE(match.winner.has_value());
  }
}

TEST_CASE("what a matcher does between its stages is told as its own deed") {
  const SyntheticScene scene = small_scene();
  const std::string yaml = kPlain.substr(std::string("matcher: ").size());
  const Slot<Matcher> matcher(std::make_shared<Meddler>(stage<Matcher>(yaml)));
  Explainer explainer(scene.pair.size(), all_pixels(scene.pair.size()));
  const DisparityRange range = DisparityRange::uniform(scene.pair.size(), scene.disparities);
  Explained explained;
  explained.result = matcher(Context(&explainer), MatchRequest{scene.pair, range, std::nullopt});
  explained.pixels = explainer.explanations();
  check_story(explained);
  for (const Explanation& pixel : explained.pixels) {
    REQUIRE(pixel.levels.size() == 2);
    if (!has_disparity(pixel.result.status)) continue;
    REQUIRE(pixel.events.back().place.path == "matcher");
    REQUIRE(pixel.events.back().effect == Effect::changed);
    REQUIRE(contains(pixel.events.back().text, "(+1)"));
  }
}

TEST_CASE("a fuser's event names the matchers that said what was taken, and what the others said") {
  const std::string sgm =
      "{type: semi_global, cost: census, penalty: {type: constant, p1: 24, p2: 96}, aggregation: "
      "{type: sgm, directions: 4}}";
  const Explained explained =
      explain_all("matcher: {type: fusion, fuser: median, matchers: [" + sgm +
                      ", {type: left_right, matcher: " + sgm +
                      "}, {type: filtered, matcher: " + sgm + ", filters: [{type: median}]}]}\n",
                  small_scene());
  check_story(explained);
  const std::string again = "matcher.matchers[1].forward.matcher";
  int alone = 0;
  for (const Explanation& pixel : explained.pixels) {
    const auto chosen =
        std::find_if(pixel.events.begin(), pixel.events.end(),
                     [](const ExplainedEvent& event) { return event.place.kind == "fuser"; });
    REQUIRE(chosen != pixel.events.end());
    const std::string& text = chosen->text;
    REQUIRE(pixel.levels.size() == 3);
    const MatchExplanation& found = pixel.levels[0].forward;
    const MatchExplanation& repeated = pixel.levels[1].forward;
    CHECK(repeated.stage_path == again);
    CHECK(is_same_curve(repeated.costs, found.costs));
    CHECK(is_same_curve(repeated.sums, found.sums));
    CHECK(std::ranges::any_of(pixel.events, [&](const ExplainedEvent& event) {
      return event.place.path == again && event.text.ends_with(" (found by matcher.matchers[0])");
    }));
    if (!has_disparity(pixel.result.status)) continue;
    CAPTURE(text);
    const bool only_first = text.find("(from matchers[0] semi_global;") != std::string::npos;
    REQUIRE(text.find(" (from matchers[") != std::string::npos);
    if (only_first) {
      ++alone;
      CHECK(text.find("; matchers[1] left_right says ") != std::string::npos);
      CHECK(text.find("; matchers[2] filtered says ") != std::string::npos);
    }
  }
  CHECK(alone > 0);
}
