// SPDX-License-Identifier: Apache-2.0
#include "support/support.hpp"

#include <cstdlib>
#include <cstring>
#include <iostream>

namespace xgm::testing {
namespace {

bool skipped = false;

template <class Volume>
bool identical_cells(const Volume& a, const Volume& b) {
  if (a.bytes() != b.bytes() || a.shape().size() != b.shape().size()) return false;
  for (int y = 0; y < a.shape().height(); ++y) {
    for (int x = 0; x < a.shape().width(); ++x) {
      if (a.shape().count(y, x) != b.shape().count(y, x)) return false;
      if (a.shape().count(y, x) > 0 && a.shape().begin(y, x) != b.shape().begin(y, x)) return false;
    }
  }
  return all_cells(a) == all_cells(b);
}

}  // namespace

const Registry& builtins() {
  static const Registry registry = Registry::with_builtins();
  return registry;
}

Image random_image(cv::Size size, std::uint64_t seed, int channels) {
  Random random(seed);
  Image image;
  for (int c = 0; c < channels; ++c) {
    cv::Mat1f& plane = image.planes.emplace_back(size);
    for (float& value : plane) value = static_cast<float>(random.integer(0, 255));
  }
  return image;
}

ImagePair shifted_pair(cv::Size size, int disparity, std::uint64_t seed, int channels) {
  ImagePair pair{random_image(size, seed, channels), random_image(size, ~seed, channels)};
  for (std::size_t c = 0; c < pair.base.planes.size(); ++c) {
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const int match_x = x - disparity;
        if (match_x < 0 || match_x >= size.width) continue;
        pair.match.planes[c](y, match_x) = pair.base.planes[c](y, x);
      }
    }
  }
  return pair;
}

cv::Mat1b random_mask(cv::Size size, double share, std::uint64_t seed) {
  Random random(seed);
  cv::Mat1b mask(size);
  for (std::uint8_t& value : mask) value = random.real(0, 1) < share ? 0 : 255;
  return mask;
}

DisparityRange random_range(cv::Size size, Interval hull, std::uint64_t seed) {
  Random random(seed);
  cv::Mat1i begin(size), end(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int a = random.integer(hull.begin, hull.end - 1);
      const int b = random.integer(hull.begin, hull.end - 1);
      const bool empty = random.integer(0, 9) == 0;
      begin(y, x) = empty ? 0 : std::min(a, b);
      end(y, x) = empty ? 0 : std::max(a, b) + 1;
    }
  }
  return {begin, end};
}

bool identical(const DisparityMap& a, const DisparityMap& b) {
  if (a.size() != b.size()) return false;
  for (int y = 0; y < a.size().height; ++y) {
    for (int x = 0; x < a.size().width; ++x) {
      if (a.at(y, x) != b.at(y, x)) return false;
      if (a.has_disparity(y, x) && a.disparity(y, x) != b.disparity(y, x)) return false;
    }
  }
  return true;
}

bool identical(const CostVolume& a, const CostVolume& b) {
  return a.max_cost == b.max_cost && identical_cells(a, b);
}
bool identical(const AggregatedVolume& a, const AggregatedVolume& b) {
  return a.fraction_bits == b.fraction_bits && identical_cells(a, b);
}

std::optional<std::filesystem::path> test_data(const std::string& what) {
  const char* folder = std::getenv("XGM_TEST_DATA");
  if (folder != nullptr && *folder != '\0') return std::filesystem::path(folder);
  std::cout << "SKIPPED: " << what << " needs real data; set XGM_TEST_DATA" << std::endl;
  skipped = true;
  return std::nullopt;
}

bool was_skipped() { return skipped; }

}  // namespace xgm::testing
