// SPDX-License-Identifier: Apache-2.0
// Follows the stages of a run and takes from what they are given and return what lies at the
// chosen pixels.
#pragma once

#include <deque>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "xgm/evaluation/explain.hpp"

namespace xgm::explain {

/// What a matcher that holds no other did, for each of the pixels; those that have no counterpart
/// in the reverse view are at x = -1.
struct Match {
  cv::Size size;
  Level level;
  bool reverse = false;
  std::vector<MatchExplanation> of;
};

class Watcher {
 public:
  Watcher(cv::Size size, std::vector<cv::Point> pixels);

  void begin(const StagePlace& place);
  void input(const StagePlace& place, const Artifact& input);
  void same_as(const StagePlace& place, const std::string& earlier);
  void end(const StagePlace& place, const Artifact& result);
  void figure(const StagePlace& place, const std::string& name, double value);

  cv::Size size() const { return size_; }
  const std::vector<cv::Point>& pixels() const { return pixels_; }
  const std::deque<Match>& matches() const { return matches_; }
  const std::vector<ExplainedEvent>& events(std::size_t pixel) const { return events_[pixel]; }

 private:
  /// What a matcher inside a stage found at each of the pixels of the forward view.
  struct Proposal {
    std::string stage;
    std::vector<PixelState> states;
  };

  /// A stage that is running. The inputs are the caller's and live as long as it runs.
  struct Frame {
    StagePlace place;
    cv::Size size;  ///< of the images it works on, as far as they are known
    bool holds_matcher = false;
    const MatchRequest* request = nullptr;
    const ImagePair* pair = nullptr;
    const DisparityMap* map = nullptr;
    const AggregatedVolume* sums = nullptr;
    const MatchResult* maps = nullptr;
    const DisparityMap* result = nullptr;  ///< while it is told
    std::vector<Proposal> proposals;
    Match* match = nullptr;
    std::string figures;
    std::string same_as;  ///< path of the stage whose result it is given

    bool is_reverse() const { return place.view == View::reverse; }
  };

  /// The map of one view at one size, as far as it has come.
  struct Track {
    cv::Size size;
    Level level;
    bool reverse = false;
    Match* match = nullptr;  ///< that made it
    std::vector<cv::Point> at;
    std::vector<std::optional<PixelState>> state;
  };

  Frame* open_frame(const StagePlace& place);
  Frame* matcher_of(const Frame& frame);
  void take_request(Frame& frame, const MatchRequest& request);
  void take_costs(Frame& frame, const CostVolume& costs);
  void take_sums(Frame& frame, const AggregatedVolume& sums);

  void images_returned(const Frame& frame, const ImagePair& result);
  void range_returned(const Frame& frame, const DisparityRange& result);
  void map_returned(Frame& frame, const DisparityMap& result);
  void maps_returned(Frame& frame, const MatchResult& result);

  Track& track(cv::Size size, const Level& level, bool reverse);
  void start(Track& track);
  cv::Point place_of(std::size_t i, const Frame& frame, cv::Size size) const;
  cv::Point counterpart(const Track& forward, std::size_t i) const;
  Match& match_of(Frame& matcher);
  void take_curves(Frame& matcher);
  void follow(const Frame& frame, Track& track, const DisparityMap* before,
              const DisparityMap& after);
  void record(std::size_t i, const Frame& frame, const Track& track,
              const std::optional<PixelState>& before, const PixelState& after);
  void propose(const Frame& frame, const Track& here, const DisparityMap& result);
  std::string choice_text(std::size_t i, const Frame& frame, const Track& here,
                          const PixelState& choice) const;
  void tell(std::size_t i, const Frame& frame, Effect effect, std::string text);

  cv::Size size_;
  std::vector<cv::Point> pixels_;
  std::vector<Frame> frames_;
  std::deque<Track> tracks_;  // deques: elements stay where they are
  std::deque<Match> matches_;
  std::vector<std::vector<ExplainedEvent>> events_;
  cv::Size announced_;  // the level whose range was told last
};

}  // namespace xgm::explain
