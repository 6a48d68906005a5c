// SPDX-License-Identifier: Apache-2.0
// What the contract checks share: a report, inputs that try a stage, and bytes to compare.
#pragma once

#include <array>
#include <exception>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "xgm/base/parallel.hpp"
#include "xgm/data/fault.hpp"
#include "xgm/stage/context.hpp"
#include "xgm/testing/contract.hpp"

namespace xgm::testing::detail {

/// Collects violations; each rule is told once per input.
class Report {
 public:
  explicit Report(const Watch& watch) : watch_(watch) {}

  /// Runs `body` on the input called `name`; what it throws is a violation.
  void with(const std::string& name, const std::function<void()>& body);
  void expect(bool holds, const char* rule);
  void expect(bool holds, const char* rule, int y, int x);
  /// A rule that runs look at, too: see xgm/data/fault.hpp and the kinds' fault_of().
  void expect_none(const std::optional<Fault>& fault);
  Violations take() { return std::move(violations_); }

 private:
  void fail(const std::string& rule, const std::string& place);

  Watch watch_;
  std::string input_;
  std::set<std::string> told_;
  Violations of_input_;
  Violations violations_;
};

/// A pair and what to search in it.
struct Input {
  std::string name;
  ImagePair pair;
  DisparityRange range;
};

/// Usual, colour, negative, wide, masked, tiny and empty images; the last ones with ragged ranges.
std::vector<Input> inputs();
/// A range per pixel, some empty, all within `hull`.
DisparityRange ragged_range(cv::Size size, Interval hull);
/// A mask with holes, and the same pair with other grey levels under it.
cv::Mat1b mask_with_holes(cv::Size size, int phase);
ImagePair with_levels_under_masks(const ImagePair& pair, float level);

/// Of the pixels that are matched, but one in ten; NaN of the others.
cv::Mat1f some_confidence(const DisparityMap& map);

/// A number in [0, 1) that depends on all arguments and nothing else.
double chance(std::uint64_t key, int y, int x, int d = 0);

/// Raw bytes, to compare with ==.
using Bytes = std::string;
Bytes bytes_of(const Image& image);
Bytes bytes_of(const ImagePair& pair);
Bytes bytes_of(const cv::Mat1f& values);
Bytes bytes_of(const DisparityMap& map);
Bytes bytes_of(const MatchResult& result);
Bytes bytes_of(const DisparityRange& range);
Bytes bytes_of(const CostVolume& volume);
Bytes bytes_of(const AggregatedVolume& volume);

/// What `run` returns, having seen that it does not depend on the number of threads.
template <class Run>
auto run_with_threads(Report& report, const Run& run) {
  auto result = [&] {
    const ThreadLimit one(1);
    return run();
  }();
  const Bytes expected = bytes_of(result);
  for (const int count : {2, 3, 8}) {
    const ThreadLimit threads(count);
    report.expect(bytes_of(run()) == expected, "the result depends on the number of threads");
  }
  return result;
}

}  // namespace xgm::testing::detail
