// SPDX-License-Identifier: Apache-2.0
#include "plugins/search_range/window_statistics/coded_map.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include "plugins/search_range/window_statistics/proposal.hpp"
#include "xgm/base/parallel.hpp"

namespace xgm::search_range {
namespace {

constexpr int kNoCode = std::numeric_limits<int>::min();
constexpr std::int64_t kLargestTable = 1 << 22;  // entries

cv::Mat1i codes_of(const DisparityMap& map) {
  cv::Mat1i codes(map.size());
  parallel_for(0, codes.rows, [&](int y) {
    const float* disparity = map.disparity[y];
    int* code = codes[y];
    for (int x = 0; x < codes.cols; ++x) {
      const double d = map.has_disparity(y, x) ? static_cast<double>(disparity[x]) : 0;
      code[x] = map.has_disparity(y, x) ? fine_floor(d) + fine_ceil(d) : kNoCode;
    }
  });
  return codes;
}

/// The lowest and the highest code; the other way round if there is none.
std::pair<std::int64_t, std::int64_t> extremes(const cv::Mat1i& codes) {
  int lowest = std::numeric_limits<int>::max(), highest = kNoCode;
  for (int y = 0; y < codes.rows; ++y) {
    const int* code = codes[y];
    for (int x = 0; x < codes.cols; ++x) {
      lowest = std::min(lowest, code[x] == kNoCode ? lowest : code[x]);
      highest = std::max(highest, code[x]);
    }
  }
  return {lowest, highest};
}

template <class Place>
void replace(cv::Mat1i& codes, const Place& place) {
  parallel_for(0, codes.rows, [&](int y) {
    int* code = codes[y];
    for (int x = 0; x < codes.cols; ++x) {
      code[x] = code[x] == kNoCode ? CodedMap::kNone : place(code[x]);
    }
  });
}

/// Through a table of all codes from the lowest to the highest.
std::vector<int> number_by_table(cv::Mat1i& codes, int lowest, std::int64_t size) {
  std::vector<int> table(static_cast<std::size_t>(size), 0), found;
  const auto entry = [&](int code) -> int& {
    return table[static_cast<std::size_t>(code) - static_cast<std::size_t>(lowest)];
  };
  for (int y = 0; y < codes.rows; ++y) {
    const int* code = codes[y];
    for (int x = 0; x < codes.cols; ++x) {
      if (code[x] != kNoCode) entry(code[x]) = 1;
    }
  }
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i] == 0) continue;
    table[i] = static_cast<int>(found.size());
    found.push_back(lowest + static_cast<int>(i));
  }
  replace(codes, entry);
  return found;
}

/// Where such a table would be too large.
std::vector<int> number_by_sorting(cv::Mat1i& codes) {
  std::vector<int> found;
  std::copy_if(codes.begin(), codes.end(), std::back_inserter(found),
               [](int code) { return code != kNoCode; });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  replace(codes, [&](int code) {
    return static_cast<int>(std::lower_bound(found.begin(), found.end(), code) - found.begin());
  });
  return found;
}

}  // namespace

CodedMap::CodedMap(const DisparityMap& map) : index(codes_of(map)) {
  const auto [lowest, highest] = extremes(index);
  if (lowest > highest) {
    index = kNone;
    return;
  }
  const std::int64_t size = highest - lowest + 1;
  codes = size <= kLargestTable ? number_by_table(index, static_cast<int>(lowest), size)
                                : number_by_sorting(index);
}

}  // namespace xgm::search_range
