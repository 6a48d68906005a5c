// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "explain/curve.hpp"
#include "explain/story.hpp"
#include "explain/watcher.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace {

void check(cv::Size size, const std::vector<cv::Point>& pixels, const cv::Mat1f& truth) {
  for (const cv::Point& pixel : pixels) {
    if (cv::Rect({}, size).contains(pixel)) continue;
    throw UsageError("pixel " + std::to_string(pixel.x) + " " + std::to_string(pixel.y) +
                     " lies outside of the images, which are " + std::to_string(size.width) +
                     " x " + std::to_string(size.height) + " pixels; give x from 0 to " +
                     std::to_string(size.width - 1) + " and y from 0 to " +
                     std::to_string(size.height - 1));
  }
  if (!truth.empty() && truth.size() != size) {
    throw UsageError("the truth is not of the images' size; give that of the same scene");
  }
}

void add_truth(LevelExplanation& level, double truth) {
  MatchExplanation& match = level.forward;
  const double here = truth / level.level.scale;
  const int nearest = static_cast<int>(std::lround(here));
  match.truth = {static_cast<float>(here), match.range.contains(nearest),
                 explain::candidate(match, nearest)};
}

PixelState result_of(const std::vector<ExplainedEvent>& events) {
  PixelState result;
  for (const ExplainedEvent& event : events) {
    if (event.after && !event.reverse && event.level.scale == 1) result = *event.after;
  }
  return result;
}

}  // namespace

class Explainer::Impl {
 public:
  Impl(cv::Size size, std::vector<cv::Point> pixels, cv::Mat1f truth)
      : truth_(std::move(truth)), watcher_(size, std::move(pixels)) {}

  explain::Watcher& watcher() { return watcher_; }

  Explanation explanation(std::size_t i) const {
    Explanation result;
    result.pixel = watcher_.pixels()[i];
    result.events = watcher_.events(i);
    result.result = result_of(result.events);
    result.levels = levels(i);
    const float truth = truth_.empty() ? kUnknown : truth_(result.pixel);
    if (std::isfinite(truth)) {
      result.truth = truth;
      for (LevelExplanation& level : result.levels) add_truth(level, truth);
    }
    result.verdict = explain::verdict(result);
    result.diagnosis = explain::diagnosis(result);
    return result;
  }

 private:
  /// Matches in the order they began; a reverse one belongs to the forward one before it.
  std::vector<LevelExplanation> levels(std::size_t i) const {
    std::vector<LevelExplanation> result;
    for (const explain::Match& match : watcher_.matches()) {
      MatchExplanation of_pixel = match.of[i];
      explain::find_candidates(of_pixel);
      if (!match.reverse) {
        result.push_back({match.level, match.size, std::move(of_pixel), std::nullopt});
      } else if (!result.empty() && result.back().size == match.size && of_pixel.pixel.x >= 0) {
        result.back().reverse = std::move(of_pixel);
      }
    }
    return result;
  }

  cv::Mat1f truth_;
  explain::Watcher watcher_;
};

bool operator==(const PixelState& a, const PixelState& b) {
  const bool none = std::isnan(a.disparity) && std::isnan(b.disparity);
  return a.status == b.status && (none || a.disparity == b.disparity);
}

std::string_view to_string(Effect effect) {
  static constexpr std::array<std::string_view, 9> kNames{"images",    "range",  "matched",
                                                          "unmatched", "kept",   "changed",
                                                          "killed",    "filled", "relabelled"};
  return kNames[static_cast<std::size_t>(effect)];
}

Explainer::Explainer(cv::Size size, std::vector<cv::Point> pixels, cv::Mat1f truth) {
  check(size, pixels, truth);
  impl_ = std::make_unique<Impl>(size, std::move(pixels), std::move(truth));
}
Explainer::~Explainer() = default;

void Explainer::stage_begin(const StagePlace& place) { impl_->watcher().begin(place); }
void Explainer::stage_input(const StagePlace& place, const Artifact& input) {
  impl_->watcher().input(place, input);
}
void Explainer::stage_end(const StagePlace& place, const StageStatistics&, const Artifact& result) {
  impl_->watcher().end(place, result);
}
void Explainer::stage_same_as(const StagePlace& place, const std::string& earlier) {
  impl_->watcher().same_as(place, earlier);
}
void Explainer::figure(const StagePlace& place, const std::string& name, double value) {
  impl_->watcher().figure(place, name, value);
}

std::vector<Explanation> Explainer::explanations() const {
  std::vector<Explanation> all;
  for (std::size_t i = 0; i < impl_->watcher().pixels().size(); ++i) {
    all.push_back(impl_->explanation(i));
  }
  return all;
}

std::vector<cv::Point> pixel_grid(cv::Size size, int step) {
  if (step < 1) throw Error("a grid needs a step of at least one pixel");
  std::vector<cv::Point> pixels;
  for (int y = std::min(step / 2, size.height - 1); y < size.height; y += step) {
    for (int x = std::min(step / 2, size.width - 1); x < size.width; x += step) {
      pixels.emplace_back(x, y);
    }
  }
  return pixels;
}

}  // namespace xgm
