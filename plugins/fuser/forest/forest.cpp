// SPDX-License-Identifier: Apache-2.0
// A random forest picks among the candidates.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "plugins/fuser/candidate_choice/choice.hpp"
#include "plugins/fuser/candidate_features/features.hpp"
#include "plugins/fuser/forest/forest_file.hpp"
#include "plugins/fuser/forest/votes.hpp"
#include "xgm/base/shipped_files.hpp"
#include "xgm/plugin.hpp"

namespace {

namespace fuser = xgm::fuser;

/// Each tree tells from the features of a pixel how likely each matcher is right, and the one with
/// the largest sum is taken. Where no candidates are more than a quarter of a pixel apart, nothing
/// is asked and the first one is picked. The picked one is averaged with those that agree with it.
class RandomForest final : public xgm::Fuser, public xgm::StatesNeeds {
 public:
  struct Parameters {
    std::string model = "models/fusion_best.forest";
    xgm::SlotList<xgm::Cost> costs;
    double agreement = 1;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("model", p.model,
            "File of the forest: a path, or that of a shipped one below the folder of the shipped "
            "pipelines. It decides how many matchers and costs there are.");
    set.add("costs", p.costs,
            "How alike both images are at a candidate, the same costs in the same order as when "
            "the forest was trained.");
    set.add("agreement", p.agreement,
            "Disparities this near to the one that is picked measure the same surface, and their "
            "mean is taken; 0 takes the picked one as it is.")
        .unit("px")
        .range(0, 10);
  }
  explicit RandomForest(Parameters p)
      : costs_(std::move(p.costs)),
        agreement_(static_cast<float>(p.agreement)),
        forest_(xgm::forest::read_forest(xgm::find_shipped(p.model))) {
    const fuser::FeatureLayout layout{forest_.matchers, forest_.costs};
    const auto refuse = [&](const std::string& what) { throw xgm::Error(p.model + ": " + what); };
    if (forest_.feature_version != fuser::kFeatureVersion || forest_.features != layout.count()) {
      refuse("was trained for other features than these of version " +
             std::to_string(fuser::kFeatureVersion) + "; train it anew");
    }
    if (costs_.size() != static_cast<std::size_t>(forest_.costs)) {
      refuse("was trained with " + std::to_string(forest_.costs) + " costs; give as many, not " +
             std::to_string(costs_.size()));
    }
  }

  int matchers() const override { return forest_.matchers; }

  xgm::DisparityMap run(const xgm::Candidates& candidates, const xgm::ImagePair& pair,
                        const xgm::Context& context) const override {
    const fuser::CandidateMaps maps(candidates, pair, costs_, context);
    cv::Mat1f confidence(pair.size(), std::numeric_limits<float>::quiet_NaN());
    cv::Mat1i choice(pair.size());
    xgm::parallel_for(0, choice.rows,
                      [&](int y) { choose_row(maps, y, choice[y], confidence[y]); });
    xgm::DisparityMap map = fuser::chosen(candidates, [&](int y, int x) { return choice(y, x); });
    xgm::parallel_for(0, choice.rows, [&](int y) {
      for (int x = 0; x < choice.cols; ++x) {
        if (choice(y, x) != fuser::kNone) map.disparity(y, x) = mean_around(candidates, map, y, x);
      }
    });
    map.confidence = confidence;
    return map;
  }

  xgm::Needs needs(const xgm::Workload& load) const override {
    return fuser::needs_of_maps(load, forest_.matchers, forest_.costs);
  }

 private:
  void choose_row(const fuser::CandidateMaps& maps, int y, int* choice, float* confidence) const {
    const auto stride = static_cast<std::size_t>(forest_.features);
    std::vector<int> disputed;
    std::vector<std::uint8_t> features;
    for (int x = 0; x < maps.pair.size().width; ++x) {
      choice[x] = fuser::first_with_disparity(maps.candidates, y, x);
      if (choice[x] == fuser::kNone) continue;
      confidence[x] = 1;
      if (!maps.disputed(y, x)) continue;
      disputed.push_back(x);
      features.resize(features.size() + stride);
      fuser::features_at(maps, y, x, features.data() + features.size() - stride);
    }
    const std::vector<int> votes = xgm::forest::votes(forest_, features);
    const float most = 255 * static_cast<float>(forest_.trees.size());
    for (std::size_t i = 0; i < disputed.size(); ++i) {
      const int x = disputed[i];
      const int* const of_pixel = votes.data() + i * static_cast<std::size_t>(forest_.matchers);
      choice[x] = best(maps.candidates, y, x, of_pixel);
      confidence[x] = static_cast<float>(of_pixel[choice[x]]) / most;
    }
  }

  /// Of those that have a disparity the first with the most votes.
  static int best(const xgm::Candidates& candidates, int y, int x, const int* votes) {
    int found = fuser::first_with_disparity(candidates, y, x);
    for (int i = found + 1; i < static_cast<int>(candidates.maps.size()); ++i) {
      const bool has = candidates.maps[static_cast<std::size_t>(i)].has_disparity(y, x);
      if (has && votes[i] > votes[found]) found = i;
    }
    return found;
  }

  /// The mean of the candidates that agree with the one that was picked.
  float mean_around(const xgm::Candidates& candidates, const xgm::DisparityMap& picked, int y,
                    int x) const {
    const float d = picked.disparity(y, x);
    float sum = 0, count = 0, lowest = d, highest = d;
    for (const xgm::DisparityMap& map : candidates.maps) {
      const float other = map.disparity(y, x);
      if (!(std::abs(other - d) <= agreement_)) continue;  // NaN if there is none
      sum += other;
      count += 1;
      lowest = std::min(lowest, other);
      highest = std::max(highest, other);
    }
    return std::clamp(sum / count, lowest, highest);  // rounding must not lead beyond them
  }

  xgm::SlotList<xgm::Cost> costs_;
  float agreement_;
  xgm::forest::Forest forest_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<RandomForest>(
      "forest",
      "A random forest picks among the disparities where they differ, by how well they match and "
      "by what is around them.",
      "M. Schoenberger, S. Sinha, M. Pollefeys: Learning to fuse proposals from multiple scanline "
      "optimizations in semi-global matching, ECCV 2018; L. Breiman: Random forests, Machine "
      "Learning 45, 2001.");
}
