// SPDX-License-Identifier: Apache-2.0
#include "record/doubts.hpp"

#include <algorithm>
#include <utility>

#include "xgm/base/text.hpp"

namespace xgm {
namespace {

// Of pixels with data, about a third of a scene is hidden or hard at most; swapped images, two that
// do not belong together and a wrong range leave less than half.
constexpr double kFewMatched = 0.5;
// Within 1 px of an end of the range lie no disparities of a scene that fits into it, and a tenth
// or more of them if it does not, or if the images are swapped.
constexpr double kManyAtEnd = 0.05;
// Of a short range an end is a good part. Matches that mean nothing spread over all disparities:
// half of what falls to one of them then is many.
constexpr double kManyOfFew = 0.5;
constexpr int kShortest = 3;  // disparities; shorter ranges consist of their ends

std::string percent(double share) { return fixed_number(100 * share, 2) + " %"; }

double share_of(const RunRecord& record, Status status) {
  return record.status_shares[static_cast<std::size_t>(status)];
}

/// Of the pixels with data; filled ones are guesses and tell nothing of the match.
double matched_share(const RunRecord& record) {
  return share_of(record, Status::matched) / (1 - share_of(record, Status::masked));
}

}  // namespace

std::vector<std::string> doubts(const MapSummary& map, const RunRecord& record) {
  std::vector<std::string> texts;
  if (matched_share(record) < kFewMatched) {
    texts.push_back("only " + percent(matched_share(record)) +
                    " of the pixels were matched; see status.png for the reasons, and check that "
                    "the images belong together, their order and the disparity range");
  }
  const Interval searched = record.disparities;
  if (searched.size() < kShortest) return texts;
  const double many = std::max(kManyAtEnd, kManyOfFew / searched.size());
  const int last = searched.end - 1;
  for (const auto& [end, share] :
       {std::pair(searched.begin, map.share_at_first()), {last, map.share_at_last()}}) {
    if (share < many) continue;
    texts.push_back(percent(share) + " of the matched disparities lie at " + std::to_string(end) +
                    ", where the search range " + std::to_string(searched.begin) + " to " +
                    std::to_string(last) +
                    " ends: does the scene reach beyond it, or are the images swapped?");
  }
  return texts;
}

}  // namespace xgm
