// SPDX-License-Identifier: Apache-2.0
// The contract checks notice stages that break their contract, and pass one that keeps it.
#include "xgm/testing/contract.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/support.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

bool tells(const Violations& violations, const std::string& rule) {
  return std::any_of(violations.begin(), violations.end(), [&](const std::string& violation) {
    return violation.find(rule) != std::string::npos;
  });
}

enum class CostFault { none, max_cost, outside, masked, levels, ragged, threads, changes, throws };

/// |difference| / 2 of the first planes, with a fault planted.
class FaultyCost final : public Cost {
 public:
  explicit FaultyCost(CostFault fault) : fault_(fault) {}

  CostVolume run(const ImagePair& pair, const VolumeShapePtr& shape,
                 const Context&) const override {
    if (fault_ == CostFault::throws && pair.size().area() == 1) throw Error("one pixel only");
    CostVolume costs(shape, fault_ == CostFault::max_cost ? 20 : 128);
    for (int y = 0; y < shape->height(); ++y)
      for (int x = 0; x < shape->width(); ++x)
        for (int i = 0; i < shape->count(y, x); ++i)
          costs.at(y, x)[i] = cost(pair, y, x, x - shape->begin(y, x) - i, shape->count(y, x));
    if (fault_ == CostFault::threads && costs.shape().cells() > 0 && costs.data()[0] < 100)
      costs.data()[0] = static_cast<std::uint8_t>(thread_count());
    if (fault_ == CostFault::changes) cv::Mat1f(pair.base.planes[0])(0, 0) += 1;
    return costs;
  }

 private:
  std::uint8_t cost(const ImagePair& pair, int y, int x, int x_match, int count) const {
    const bool inside = x_match >= 0 && x_match < pair.size().width;
    if (!inside) return fault_ == CostFault::outside ? std::uint8_t{9} : CostVolume::kNoMatch;
    if (!pair.match.is_valid(y, x_match) && fault_ != CostFault::masked)
      return CostVolume::kNoMatch;
    const cv::Mat1f& base = pair.base.planes[0];
    float value = std::abs(base(y, x) - pair.match.planes[0](y, x_match)) / 2;
    if (fault_ == CostFault::levels && x > 0) value = base(y, x - 1) / 2;
    if (fault_ == CostFault::ragged) value = static_cast<float>(count % 100);
    return static_cast<std::uint8_t>(value);
  }

  CostFault fault_;
};

enum class MapFault { none, status, lost, unmasked, size };

/// Returns the map as it is, but for a planted fault.
class FaultyFilter final : public Filter {
 public:
  explicit FaultyFilter(MapFault fault) : fault_(fault) {}

  DisparityMap run(const DisparityMap& map, const ImagePair&, const Context&) const override {
    if (fault_ == MapFault::size) return DisparityMap({3, 3});
    DisparityMap result = map.clone();
    for (int y = 0; y < map.size().height; ++y) {
      for (int x = 0; x < map.size().width; ++x) {
        const bool missing_neighbour = x > 0 && !map.has_disparity(y, x - 1);
        if (fault_ == MapFault::status && !map.has_disparity(y, x)) result.disparity(y, x) = 0;
        if (fault_ == MapFault::unmasked && !map.has_disparity(y, x))
          result.set(y, x, 1, Status::filled);
        if (fault_ == MapFault::lost && missing_neighbour && map.has_disparity(y, x))
          result.invalidate(y, x, Status::peak);
      }
    }
    return result;
  }

 private:
  MapFault fault_;
};

/// Takes the first disparity of each pixel, or one too far.
class FirstDisparity final : public Selection {
 public:
  explicit FirstDisparity(float offset) : offset_(offset) {}

  DisparityMap run(const AggregatedVolume& sums, const Context&) const override {
    const VolumeShape& shape = sums.shape();
    DisparityMap map(shape.size());
    for (int y = 0; y < shape.height(); ++y)
      for (int x = 0; x < shape.width(); ++x)
        for (int i = shape.count(y, x) - 1; i >= 0; --i)
          if (sums.at(y, x)[i] != AggregatedVolume::kNoMatch)
            map.set(y, x, static_cast<float>(shape.begin(y, x) + i) + offset_);
    return map;
  }

 private:
  float offset_;
};

/// Matches everything with the same disparity, in range or not.
class FixedMatcher final : public Matcher {
 public:
  MatchResult run(const MatchRequest& request, const Context&) const override {
    MatchResult result{DisparityMap(request.pair.size()), {}};
    result.forward.set(0, 0, 1000);
    return result;
  }
};

class TooFar final : public Refinement {
 public:
  DisparityMap run(const DisparityMap& map, const AggregatedVolume&,
                   const Context&) const override {
    DisparityMap result = map.clone();
    result.disparity += 0.6F;
    return result;
  }
};

class FewerRows final : public Preprocess {
 public:
  ImagePair run(const ImagePair& pair, const Context&) const override {
    ImagePair result = pair;
    result.match.planes[0] = cv::Mat1f(pair.size().height + 1, pair.size().width, 0.0F);
    return result;
  }
};

/// Adds a level that it was fitted to; what is handed on is less by `lost`.
class Forgetful final : public Preprocess {
 public:
  explicit Forgetful(double lost) : lost_(lost) {}
  ImagePair run(const ImagePair& pair, const Context&) const override {
    return Part(1, 0).run(pair, {});
  }
  std::shared_ptr<const PartPreprocess> fitted(const PairWindows&, const Context&) const override {
    return std::make_shared<Part>(1, lost_);
  }
  std::shared_ptr<const PartPreprocess> restored(const std::string& state,
                                                 cv::Size) const override {
    return lost_ < 1 ? std::make_shared<Part>(std::stod(state), lost_) : nullptr;
  }

 private:
  struct Part final : PartPreprocess {
    Part(double level, double lost) : level_(level), lost_(lost) {}
    int margin() const override { return 0; }
    ImagePair run(const ImagePair& part, cv::Point) const override {
      ImagePair result = part;
      for (cv::Mat1f& plane : result.match.planes) plane = cv::Mat1f(plane + level_);
      return result;
    }
    std::string state() const override { return std::to_string(level_ - lost_); }
    double level_, lost_;
  };
  double lost_;
};

class Narrow final : public SearchRange {
 public:
  DisparityRange run(const DisparityMap&, const DisparityRange& limits,
                     const Context&) const override {
    return DisparityRange::uniform(limits.size(), {limits.hull().begin, limits.hull().begin});
  }
};

enum class SureFault { none, everywhere, large, levels };

/// As sure of everything, with one fault.
class FaultyConfidence final : public Confidence {
 public:
  explicit FaultyConfidence(SureFault fault) : fault_(fault) {}
  cv::Mat1f run(const Evidence& evidence, const Context&) const override {
    cv::Mat1f sure(evidence.map.size(), fault_ == SureFault::large ? 2.0F : 0.5F);
    if (fault_ == SureFault::levels && evidence.pair.base.planes[0](0, 0) == 255) sure *= 0.5;
    if (fault_ == SureFault::everywhere) return sure;
    for (int y = 0; y < sure.rows; ++y) {
      for (int x = 0; x < sure.cols; ++x) {
        if (evidence.map.has_disparity(y, x)) continue;
        sure(y, x) = std::numeric_limits<float>::quiet_NaN();
      }
    }
    return sure;
  }

 private:
  SureFault fault_;
};

class Inventive final : public Consistency {
 public:
  MatchResult run(const MatchResult& result, const Context&) const override {
    MatchResult checked{result.forward.clone(), result.reverse->clone()};
    for (int x = 0; x < checked.forward.size().width; ++x) checked.forward.set(0, x, 1);
    return checked;
  }
};

}  // namespace

TEST_CASE("contract checks: a cost that keeps the contract passes, each planted fault is told") {
  CHECK(check_cost(FaultyCost(CostFault::none)) == Violations{});
  CHECK(tells(check_cost(FaultyCost(CostFault::max_cost)), "exceeds max_cost"));
  CHECK(tells(check_cost(FaultyCost(CostFault::outside)), "not kNoMatch"));
  CHECK(tells(check_cost(FaultyCost(CostFault::masked)), "masked image: a cost where nothing"));
  CHECK(tells(check_cost(FaultyCost(CostFault::levels)), "grey levels of masked pixels"));
  CHECK(tells(check_cost(FaultyCost(CostFault::ragged)), "which other cells"));
  CHECK(tells(check_cost(FaultyCost(CostFault::threads)), "number of threads"));
  CHECK(tells(check_cost(FaultyCost(CostFault::changes)), "images were changed"));
  CHECK(tells(check_cost(FaultyCost(CostFault::throws)), "image of one pixel: it throws"));
}

TEST_CASE("contract checks: a filter that keeps the contract passes, each planted fault is told") {
  CHECK(check_filter(FaultyFilter(MapFault::none)) == Violations{});
  CHECK(tells(check_filter(FaultyFilter(MapFault::status)), "disagree"));
  CHECK(tells(check_filter(FaultyFilter(MapFault::lost)), "a missing pixel takes another"));
  CHECK(tells(check_filter(FaultyFilter(MapFault::unmasked)), "other pixels are masked"));
  CHECK(tells(check_filter(FaultyFilter(MapFault::size)), "image's size"));
}

TEST_CASE(
    "contract checks: a confidence that keeps the contract passes, each planted fault is told") {
  CHECK(check_confidence(FaultyConfidence(SureFault::none)) == Violations{});
  CHECK(tells(check_confidence(FaultyConfidence(SureFault::everywhere)), "without a disparity"));
  CHECK(tells(check_confidence(FaultyConfidence(SureFault::large)), "not in 0 to 1"));
  CHECK(tells(check_confidence(FaultyConfidence(SureFault::levels)), "grey levels of masked"));
}

TEST_CASE("contract checks: faults of the other kinds are told") {
  CHECK(check_selection(FirstDisparity(0)) == Violations{});
  CHECK(tells(check_selection(FirstDisparity(0.5F)), "not a whole one"));
  CHECK(tells(check_selection(FirstDisparity(1000)), "pixel's range"));
  const Violations matcher = check_matcher(FixedMatcher());
  CHECK(tells(matcher, "outside the range"));
  CHECK(tells(matcher, "status masked"));
  CHECK(tells(matcher, "fewer than half"));
  CHECK(tells(check_refinement(TooFar()), "more than half a pixel"));
  CHECK(tells(check_preprocess(FewerRows()), "base image's size"));
  CHECK_FALSE(tells(check_preprocess(Forgetful(0)), "state()"));
  CHECK(tells(check_preprocess(Forgetful(0.5)), "makes of a state() is not the same"));
  CHECK(tells(check_preprocess(Forgetful(1)), "does not know the state()"));
  CHECK(tells(check_search_range(Narrow()), "nothing to search"));
  CHECK(tells(check_consistency(Inventive()), "a disparity was added"));
}

TEST_CASE("contract checks: check_stage finds the kind") {
  CHECK(check_stage(FirstDisparity(0)) == Violations{});
  CHECK(tells(check_stage(FirstDisparity(0.5F)), "not a whole one"));
  CHECK(tells(check_stage(Stage{}), "no kind"));
}
