// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/pair_windows.hpp"

#include "xgm/data/crop.hpp"

namespace xgm {

PairWindows::~PairWindows() = default;

ImagePair PairInMemory::read(const cv::Rect& window) const { return crop(pair_, window); }

}  // namespace xgm
