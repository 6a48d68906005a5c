// SPDX-License-Identifier: Apache-2.0
// What a run is given besides images: its resources, who is told of it, and how it is ended.
#pragma once

#include <stop_token>
#include <string>

#include "xgm/stage/run_facts.hpp"

namespace xgm {

class KeptResults;
class Observer;

/// Nothing here changes what a run finds, nor anything in other runs of the process.
struct RunOptions {
  Observer* observer = nullptr;  ///< told of every stage; outlives the run; null: nobody
  /// At least 1; 0: thread_count() of the calling thread, which is all processors if nobody has
  /// said otherwise. OpenCV, which some plugins call, has a number of threads of its own, one for
  /// the process, which a run neither reads nor sets: cv::setNumThreads() is for the program to
  /// call. No result depends on it.
  int threads = 0;
  /// One of simd_targets(); empty: simd_target() of the calling thread, which is the best if nobody
  /// has said otherwise. Throws Error if this processor does not have it.
  std::string simd{};
  /// Ends the run from another thread: it throws Cancelled, usually within a tenth of a second.
  /// Single calls of OpenCV come to their end before: a tile of ransac_deskew 0.3 s, the whole of
  /// opencv_sgbm.
  std::stop_token stop{};
  KeptResults* kept = nullptr;  ///< of the same question; outlives the run; null: none
  RunFacts facts{};  ///< what stages may ask for; runs of scenes fill in what is known of them
};

}  // namespace xgm
