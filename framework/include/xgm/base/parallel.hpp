// SPDX-License-Identifier: Apache-2.0
// Loops over independent work. Results never depend on the number of threads.
#pragma once

#include <functional>

#include "xgm/base/export.hpp"

namespace xgm {

/// Number of threads that the loops below use. Set per run by the pipeline.
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
/// The exception of the smallest failing i is rethrown after all threads have stopped.
XGM_API void parallel_for(int begin, int end, const std::function<void(int)>& body);

/// Walks `lines` lines of `length` pixels so that line y follows line y-1 `lag` pixels behind:
/// body(line, first, last) handles pixels [first, last) of a line and is called in ascending order
/// within a line; when it is called, line-1 is finished up to min(length, last + lag), line-2 up to
/// min(length, last + 2 * lag), and so on. A line is begun only after line - thread_count() is
/// finished, so a ring of thread_count() + k lines is enough for a body that looks k lines back.
/// Exceptions in `body` end the process: it must not throw.
XGM_API void wavefront(int lines, int length, int lag,
                       const std::function<void(int line, int first, int last)>& body);

}  // namespace xgm
