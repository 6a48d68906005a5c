// SPDX-License-Identifier: Apache-2.0
// A PFM of one channel that is written part by part, in any order.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "io/unfinished_file.hpp"

namespace xgm {

/// Nobody sees the file before it is finished. All of its bytes are reserved in the beginning, so
/// that a disk that is too small is no surprise in the end.
class PfmInParts {
 public:
  /// Throws Error if the file cannot be made.
  PfmInParts(const std::string& file, cv::Size size);

  /// NaN is written as +inf. Throws Error.
  void put(const cv::Rect& place, const cv::Mat1f& part);
  /// All pixels have been put. Throws Error.
  void finish();

 private:
  struct Open {
    Open() = default;
    ~Open();
    Open(const Open&) = delete;
    Open& operator=(const Open&) = delete;
    int number = -1;
  };

  void write(const void* data, std::size_t bytes, std::int64_t at) const;

  std::string name_;
  cv::Size size_;
  UnfinishedFile file_;
  Open open_{};
  std::int64_t pixels_begin_ = 0;
  std::int64_t missing_;  ///< pixels
  std::vector<float> row_{};
};

}  // namespace xgm
