// SPDX-License-Identifier: Apache-2.0
// Why does a pixel have the disparity it has, or none? Watches a run and keeps all that happens to
// chosen pixels.
#pragma once

#include <limits>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/stage/context.hpp"

namespace xgm {

inline constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// What a map says of one pixel.
struct PixelState {
  float disparity = kUnknown;  ///< px of the map's level, NaN if there is none
  Status status = Status::out_of_range;
  /// Equal disparities (or none in both) and equal statuses.
  XGM_API friend bool operator==(const PixelState& a, const PixelState& b);
};

/// One disparity of a curve. NaN: cannot be matched there, or not known.
struct Candidate {
  int disparity = 0;
  float cost = kUnknown;
  float sum = kUnknown;
};

/// The true disparity, seen from one level.
struct ExplainedTruth {
  float disparity = 0;    ///< px of the level; not rounded
  bool searched = false;  ///< whether the nearest whole disparity is in the range
  Candidate nearest;      ///< that whole disparity
};

/// What one matcher did for the pixel in one view at one level. All disparities are px of the
/// level and have the signs of the view (negative for the reverse one); sums are in units of the
/// cost, and right up to a constant of the pixel.
struct MatchExplanation {
  std::string stage_path;  ///< of the matcher
  std::string plugin;
  cv::Point pixel;  ///< of the level, in this view
  Interval range;   ///< searched here; may be empty
  /// One number per disparity of `range`; NaN = cannot be matched (outside the other image, or no
  /// data). Empty if the matcher shows none.
  std::vector<float> costs;
  std::vector<float> sums;
  std::optional<Candidate> winner;     ///< as selected; the lowest of the curve if none was
  std::optional<Candidate> runner_up;  ///< best local minimum not beside the winner
  std::optional<float> shift;          ///< of the refinement, px
  PixelState result;                   ///< after all stages at this level
  std::optional<ExplainedTruth> truth;
};

struct LevelExplanation {
  Level level;  ///< its scale: how many times smaller than the images it is
  cv::Size size;
  MatchExplanation forward;
  /// The match image's pixel that the forward winner points at; none if that is outside, or if the
  /// reverse view is not matched.
  std::optional<MatchExplanation> reverse;
};

enum class Effect {
  images,      ///< a preprocess stage: what it did to the images here
  range,       ///< what is to be searched
  matched,     ///< got a disparity
  unmatched,   ///< was considered, and got none
  kept,        ///< left as it was
  changed,     ///< got another disparity
  killed,      ///< lost its disparity
  filled,      ///< got one back
  relabelled,  ///< has no disparity, as before, but for another reason
};
/// "images", "range", "matched", ...
XGM_API std::string_view to_string(Effect effect);

struct ExplainedEvent {
  StagePlace place;  ///< of the stage, which may be gone
  Level level;       ///< that the pixel is of
  bool reverse = false;
  Effect effect = Effect::kept;
  std::optional<PixelState> before;  ///< none for images, range, and the first map
  std::optional<PixelState> after;   ///< none for images and range
  std::string text;                  ///< "12 -> 12.31 (+0.31)"
};

struct Explanation {
  cv::Point pixel;
  PixelState result;                     ///< of the run, px
  std::optional<float> truth;            ///< px
  std::string verdict;                   ///< why the pixel is what it is, for people
  std::string diagnosis;                 ///< with truth: where the matcher went wrong; else empty
  std::vector<LevelExplanation> levels;  ///< in the order they were matched, coarsest first
  std::vector<ExplainedEvent> events;    ///< in the order they happened
};

/// Keeps what happens to `pixels` of images of `size`. Feed it one run (or a matcher's). The curves
/// of these pixels are kept, nothing else; volumes and maps are read while they live.
///
/// A pixel (x, y) is looked for at a level of scale s at (floor(x / s), floor(y / s)), the pixel
/// that covers it. A matcher that moves pixels otherwise (one that turns the images) is seen from
/// outside: what happened inside is shown for the same place, and its result is right again.
class XGM_API Explainer final : public Observer {
 public:
  /// `truth`: disparities of the base view, px, not finite = unknown; may be empty. Throws
  /// UsageError if a pixel lies outside, or the truth is of another size.
  Explainer(cv::Size size, std::vector<cv::Point> pixels, cv::Mat1f truth = {});
  ~Explainer() override;

  void stage_begin(const StagePlace& place) override;
  void stage_input(const StagePlace& place, const Artifact& input) override;
  void stage_end(const StagePlace& place, const StageStatistics& statistics,
                 const Artifact& result) override;
  void stage_same_as(const StagePlace& place, const std::string& earlier) override;
  void figure(const StagePlace& place, const std::string& name, double value) override;

  /// One per pixel, in the order given.
  std::vector<Explanation> explanations() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Every `step`-th pixel of every `step`-th row, from the middle of the first cell on: never none.
XGM_API std::vector<cv::Point> pixel_grid(cv::Size size, int step);

/// For people: 100 columns of ASCII.
XGM_API std::string to_text(const Explanation& explanation);

/// One object: {x, y, disparity, status, verdict, truth, diagnosis, units, levels, events}.
/// - levels, coarsest first: {scale, size: [width, height], ...match, reverse: match or null}
/// - a match: {stage, plugin, x, y, range: [first, last] both included or null if empty,
///   costs, sums: one number per disparity of the range (null: no match) or null if unknown,
///   winner, runner_up: {disparity, cost, sum} or null, shift, disparity, status,
///   truth: {disparity, searched, cost, sum} or null}
/// - events: {stage, plugin, scale, view, effect, before, after: {disparity, status} or null, text}
/// Disparities are px of their level. docs/explain.md says more.
XGM_API std::string to_json(const Explanation& explanation);
/// An array of them: explain.json.
XGM_API std::string to_json(const std::vector<Explanation>& explanations);

}  // namespace xgm
