// SPDX-License-Identifier: Apache-2.0
// Loops over independent work. Results never depend on the number of threads. All that belongs to
// the calling thread's run (SIMD target, memory, cancelling) holds for the threads of a loop, too.
#pragma once

#include <functional>

#include "xgm/base/export.hpp"

namespace xgm {

/// Number of threads that the loops below use when the calling thread calls them: that of its run,
/// else all processors. Within a loop, further loops have one thread.
XGM_API int thread_count();

/// Sets thread_count() of the calling thread for as long as it lives; 0 leaves it as it is.
class XGM_API ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  int before_;
};

/// Calls body(i) once for every i in [begin, end), in any order, on thread_count() threads.
/// The exception of the smallest failing i is rethrown after all threads have stopped. Throws
/// Cancelled, also without having called body for every i, if the run is cancelled.
XGM_API void parallel_for(int begin, int end, const std::function<void(int)>& body);

/// Pixels [first, last) of a line that a front of opposed_wavefronts() has come to.
struct Stretch {
  int front;  ///< 0, or 1, which comes from the other end: its line l is line lines - 1 - l of 0
  int line;   ///< of this front
  bool new_line;  ///< whether the other front was not there before
  int first, last;
};

/// Walks twice along `lines` lines of `length` pixels: from the first line to the last, and from
/// the last to the first, at the same time if there is more than one thread. Within each front,
/// line y follows line y-1 `lag` pixels behind: `body` is called in ascending order of the pixels
/// of a line; when it is called, line-1 is finished up to min(length, last + lag), line-2 up to
/// min(length, last + 2 * lag), and so on. Half of the threads are in each front; at the end one
/// more may help. A line is begun only when all before it are finished but those that the others
/// are at: with n threads a ring of n / 2 + 1 + k lines is enough for a body that looks k lines
/// back. No line is in work in both fronts at once: the one that comes later waits. So two threads
/// have a front each, and neither needs what the other one has just written. Exceptions in `body`
/// end the process: it must not throw. Throws Cancelled, without having come to the end, if the run
/// is cancelled.
XGM_API void opposed_wavefronts(int lines, int length, int lag,
                                const std::function<void(const Stretch&)>& body);

}  // namespace xgm
