// SPDX-License-Identifier: Apache-2.0
#include "plugins/preprocess/ransac_deskew/key_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "plugins/preprocess/ransac_deskew/descriptors.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/data/image_parts.hpp"

namespace xgm::ransac_deskew {
namespace {

// SIFT keeps some sixty floats per pixel. Tiles bound that for images of any size, and spread the
// key points over the image, which a linear model needs more than the very best ones.
const cv::Size kTile(1024, 1024);
constexpr int kTileMargin = 32;     // so that key points near a tile's border are not lost
constexpr int kSmallest = 16;       // pixels; nothing to find in less
constexpr double kContrast = 0.01;  // below SIFT's 0.04: dark images have key points, too, and the
                                    // count keeps the strongest
constexpr int kMaskMargin = 8;      // pixels; the edge of a mask is no feature of the scene

// Tiles searched at once, on as many threads: each needs some 300 MB.
constexpr int kTilesAtOnce = 4;

// A plane has three numbers: more pixels than these do not make it better. Of larger images, bands
// of whole rows are looked at: what is seen in one view is in the same rows of the other, in
// whatever column.
constexpr double kEnoughPixels = 16 << 20;
constexpr int kBands = 4;         // far apart, for the slope along y
constexpr int kFewestRows = 128;  // key points of the larger scales need some

struct View {
  cv::Mat1b grey;
  cv::Mat1b usable;
};

View prepare(const Image& image) {
  View view;
  cv::Mat1f grey = image.grey();
  view.usable = cv::Mat1b(image.size(), 255);
  if (!image.valid.empty()) {
    grey = grey.clone();
    grey.setTo(0, image.valid == 0);
    const int side = 2 * kMaskMargin + 1;
    cv::erode(image.valid != 0, view.usable, cv::Mat1b(side, side, std::uint8_t{1}));
  }
  grey.convertTo(view.grey, CV_8U);
  return view;
}

cv::Rect with_margin(const cv::Rect& tile, int margin, cv::Size image) {
  return cv::Rect(tile.x - margin, tile.y - margin, tile.width + 2 * margin,
                  tile.height + 2 * margin) &
         cv::Rect({0, 0}, image);
}

/// The view of one image in `seen`, as it is in that of the whole image.
View view_of(const PairWindows& pair, bool of_match, const cv::Rect& seen) {
  const cv::Rect read = with_margin(seen, kMaskMargin, pair.size());
  const ImagePair part = pair.read(read);
  const View view = prepare(of_match ? part.match : part.base);
  const cv::Rect inside(seen.tl() - read.tl(), seen.size());
  return {view.grey(inside), view.usable(inside)};
}

/// The key points that lie in `tile` itself, seen with a margin around it.
KeyPoints detect_in_tile(const PairWindows& pair, bool of_match, const cv::Rect& tile, int count) {
  const cv::Rect seen = with_margin(tile, kTileMargin, pair.size());
  const View view = view_of(pair, of_match, seen);
  std::vector<cv::KeyPoint> points;
  cv::Mat1f descriptors;
  const auto sift = cv::SIFT::create(count, 3, kContrast);
  sift->detectAndCompute(view.grey, view.usable, points, descriptors);
  KeyPoints found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const cv::Point2f at = points[i].pt + cv::Point2f(seen.tl());
    if (cv::Rect2f(tile).contains(at)) found.add(at, descriptors[static_cast<int>(i)]);
  }
  return found;
}

/// Where key points are looked for: everywhere, or in bands in the middle of equal parts.
std::vector<cv::Rect> places(cv::Size image) {
  if (double{1} * image.width * image.height <= kEnoughPixels) return image_parts(image, kTile);
  const int rows = std::clamp(static_cast<int>(kEnoughPixels / kBands / image.width),
                              std::min(kFewestRows, image.height / kBands), image.height / kBands);
  std::vector<cv::Rect> all;
  for (int i = 0; i < kBands; ++i) {
    const auto middle = static_cast<int>(std::int64_t{image.height} * (2 * i + 1) / (2 * kBands));
    for (const cv::Rect& tile : image_parts({image.width, rows}, kTile)) {
      all.push_back(tile + cv::Point(0, middle - rows / 2));
    }
  }
  return all;
}

/// Key points of both views, tile by tile.
std::array<KeyPoints, 2> detect(const PairWindows& pair, int count) {
  const std::vector<cv::Rect> tiles = places(pair.size());
  const int each = static_cast<int>(tiles.size());
  std::vector<KeyPoints> parts(2 * tiles.size());
  const ThreadLimit memory_limit(std::min(thread_count(), kTilesAtOnce));
  parallel_for(0, 2 * each, [&](int i) {
    parts[static_cast<std::size_t>(i)] = detect_in_tile(
        pair, i >= each, tiles[static_cast<std::size_t>(i % each)], std::max(1, count / each));
  });
  std::array<KeyPoints, 2> found;
  for (std::size_t i = 0; i < parts.size(); ++i) found[i >= tiles.size()].add(parts[i]);
  return found;
}

}  // namespace

std::vector<Correspondence> match_key_points(const PairWindows& pair,
                                             const KeyPointOptions& options) {
  const cv::Size size = pair.size();
  if (std::min(size.width, size.height) < kSmallest) return {};
  const auto [base, match] = detect(pair, options.count);
  std::vector<Correspondence> found;
  for (const auto& [i, j] : mutual_matches(base, match, options.ratio)) {
    const cv::Point2d p = base.at[i], q = match.at[j];
    if (std::abs(q.y - p.y) <= options.max_dy) found.push_back({q.x, p.y, q.y - p.y});
  }
  return found;
}

double key_point_pixels(cv::Size size) {
  double pixels = 0;
  for (const cv::Rect& tile : places(size)) pixels += tile.area();
  return pixels;
}

double key_point_bytes(cv::Size size, int threads) {
  // Six blurred images and five differences of them, of floats, of four times the pixels, and a
  // third more for the octaves: 235. Measured 236 for one tile to 276 for six of different sizes,
  // which leave holes in the heap.
  constexpr double kSiftBytesPerPixel = 255;
  constexpr double kViewBytesPerPixel = 2;  // grey levels and mask
  const std::vector<cv::Rect> tiles = places(size);
  double largest = 0;
  for (const cv::Rect& tile : tiles) {
    largest = std::max(largest, double(with_margin(tile, kTileMargin, size).area()));
  }
  const int at_once = std::min({threads, kTilesAtOnce, 2 * static_cast<int>(tiles.size())});
  return at_once * (kViewBytesPerPixel + kSiftBytesPerPixel) * largest;
}

}  // namespace xgm::ransac_deskew
