// SPDX-License-Identifier: Apache-2.0
// Stages that only remember what they were asked, for tests of the matchers that hold stages.
#pragma once

#include <limits>
#include <vector>

#include "support/support.hpp"

namespace xgm::testing::matchers {

/// What a remembering matcher was asked, and where in the pipeline.
struct Asked {
  MatchRequest request;
  std::string path;
};
inline std::vector<Asked>& asked() {
  static std::vector<Asked> all;
  return all;
}

/// Answers every pixel with the first disparity of its range (plus `offset`), remembers the
/// request, and gives a reverse map if told so.
class FakeMatcher final : public Matcher {
 public:
  struct Parameters {
    bool range_maps = true;
    bool reverse = false;
    double offset = 0;
  };
  static void describe(Parameters& p, ParameterSet& set) {
    set.add("range_maps", p.range_maps, "Whether it accepts range maps.");
    set.add("reverse", p.reverse, "Whether it gives a reverse map.");
    set.add("offset", p.offset, "Added to its disparities.");
  }
  explicit FakeMatcher(Parameters parameters) : parameters_(parameters) {}

  bool accepts_range_maps() const override { return parameters_.range_maps; }
  bool gives_reverse_map() const override { return parameters_.reverse; }

  MatchResult run(const MatchRequest& request, const Context& context) const override {
    asked().push_back({request, context.path()});
    MatchResult result{answer(request.range, request.pair.base), std::nullopt};
    if (parameters_.reverse) {
      result.reverse =
          answer(request.reverse_range ? *request.reverse_range : request.range.reversed(),
                 request.pair.match);
    }
    return result;
  }

 private:
  DisparityMap answer(const DisparityRange& range, const Image& view) const {
    DisparityMap map(range.size(), Status::out_of_range);
    for (int y = 0; y < map.size().height; ++y) {
      for (int x = 0; x < map.size().width; ++x) {
        const Interval interval = range.at(y, x);
        if (!view.is_valid(y, x))
          map.invalidate(y, x, Status::masked);
        else if (!interval.empty()) {
          map.set(y, x, static_cast<float>(interval.begin + parameters_.offset));
        }
      }
    }
    return map;
  }

  Parameters parameters_;
};

/// Proposes the same interval for every pixel.
class FakeSearchRange final : public SearchRange {
 public:
  struct Parameters {
    int begin = 0;
    int end = 1;
  };
  static void describe(Parameters& p, ParameterSet& set) {
    set.add("begin", p.begin, "First disparity.");
    set.add("end", p.end, "After the last disparity.");
  }
  explicit FakeSearchRange(Parameters parameters) : parameters_(parameters) {}
  DisparityRange run(const DisparityMap&, const DisparityRange& limits,
                     const Context&) const override {
    return DisparityRange::uniform(limits.size(), {parameters_.begin, parameters_.end});
  }

 private:
  Parameters parameters_;
};

/// Invalidates nothing.
class FakeConsistency final : public Consistency {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit FakeConsistency(Parameters) {}
  MatchResult run(const MatchResult& result, const Context&) const override { return result; }
};

inline const Registry& with_fakes() {
  static const Registry registry = [] {
    Registry all = Registry::with_builtins();
    all.add<FakeMatcher>("fake", "Remembers what it is asked.");
    all.add<FakeSearchRange>("fake", "Proposes one interval.");
    all.add<FakeConsistency>("fake", "Finds everything consistent.");
    return all;
  }();
  return registry;
}

inline std::shared_ptr<const Matcher> matcher_with_fakes(const std::string& yaml) {
  asked().clear();
  return make_stage<Matcher>(yaml, with_fakes());
}

inline ImagePair random_pair(cv::Size size, std::uint64_t seed, int channels = 1) {
  return {random_image(size, seed, channels), random_image(size, seed + 1, channels)};
}

inline bool same_range(const DisparityRange& a, const DisparityRange& b) {
  if (a.size() != b.size()) return false;
  for (int y = 0; y < a.size().height; ++y) {
    for (int x = 0; x < a.size().width; ++x) {
      const Interval i = a.at(y, x);
      const Interval j = b.at(y, x);
      if (!(i == j) && !(i.empty() && j.empty())) return false;
    }
  }
  return true;
}

/// Remembers the progress that it is told.
class ProgressObserver final : public Observer {
 public:
  void progress(double share) override { shares.push_back(share); }
  std::vector<double> shares;
};

}  // namespace xgm::testing::matchers
