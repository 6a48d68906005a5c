// SPDX-License-Identifier: Apache-2.0
// The warnings of several files in one list.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "xgm/io/image_io.hpp"

namespace xgm {

inline void append(std::vector<std::string>& all, const std::vector<std::string>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// The value; its warnings go to `all`.
template <class What>
What take(Noted<What> read, std::vector<std::string>& all) {
  append(all, read.warnings);
  return std::move(read.value);
}

}  // namespace xgm
