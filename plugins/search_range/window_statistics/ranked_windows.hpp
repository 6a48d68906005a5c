// SPDX-License-Identifier: Apache-2.0
// Two percentiles of the windows around pixels, two ways that give the same.
#pragma once

#include "plugins/search_range/window_statistics/coded_map.hpp"
#include "plugins/search_range/window_statistics/window_ranks.hpp"

namespace xgm::search_range {

/// What is asked, and where the answers go: the proposals of asked pixels whose windows are not
/// empty.
struct RankedWindows {
  const CodedMap& map;
  const cv::Mat1b& asked;
  int radius;
  Percentiles percentiles;
  int relaxation;
  Proposal& proposal;

  /// The place of percentile p among `total` values, from 1: nearest rank.
  static int rank(double percentile, int total);
  /// The answer at (y, x), as indices into map.codes.
  void answer(int y, int x, int low, int high) const {
    proposal.set(y, x, {map.fine_floor(low) - relaxation, map.fine_ceil(high) + relaxation + 1});
  }
};

/// One histogram slides along each row; a step adds a column of pixels and removes one, so that a
/// pixel costs 2 * window reads. Any number of codes.
/// T. S. Huang, G. J. Yang, G. Y. Tang: A fast two-dimensional median filtering algorithm, 1979.
void rank_by_sliding(const RankedWindows& windows);

/// Each column has a histogram of its own that slides down; a step of the window to the right adds
/// one of them and removes one, so that a pixel costs the same whatever the window. Histograms have
/// two levels, of which the fine one is only kept where it is read.
/// S. Perreault, P. Hebert: Median filtering in constant time, IEEE TIP 16(9), 2007.
void rank_by_columns(const RankedWindows& windows);

/// Whether the column histograms stay small enough for the caches.
bool columns_fit(const RankedWindows& windows);

}  // namespace xgm::search_range
