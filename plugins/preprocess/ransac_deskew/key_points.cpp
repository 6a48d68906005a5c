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

// Tiles searched at once, on as many threads: each needs up to 300 MB.
constexpr int kTilesAtOnce = 4;

// A plane has three numbers: more pixels than these do not make it better. Of larger images, bands
// of whole rows are looked at: what is seen in one view is in the same rows of the other, in
// whatever column.
constexpr double kEnoughPixels = 16 << 20;
constexpr int kBands = 4;         // far apart, for the slope along y
constexpr int kFewestRows = 128;  // key points of the larger scales need some

// SIFT doubles what it is given, so that most of its time goes to the finest scale. Large images
// have enough key points without it: on Middlebury's Aloe (1282 x 1110) 1190 matches agree at half
// the size and 689 at the whole, and the models differ by less than 0.05 px.
constexpr double kLargeImage = 1 << 20;

double pixels_of(cv::Size image) { return double{1} * image.width * image.height; }

/// How many times smaller an image is made before key points are looked for.
int reduction(cv::Size image) {
  const bool narrow = std::min(image.width, image.height) < 2 * kFewestRows;
  return pixels_of(image) > kLargeImage && !narrow ? 2 : 1;
}

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

/// Means of `factor` x `factor` pixels; usable where all of them are (of xgm::halve: where any is,
/// so that the edge of a mask would show). What is left over is cut off.
View reduced(const View& view, int factor) {
  if (factor == 1) return view;
  const cv::Size size = view.grey.size() / factor;
  const cv::Rect whole({}, size * factor);
  View small;
  cv::resize(view.grey(whole), small.grey, size, 0, 0, cv::INTER_AREA);
  cv::resize(view.usable(whole), small.usable, size, 0, 0, cv::INTER_AREA);
  small.usable = small.usable == 255;
  return small;
}

/// Where a point of the reduced image is: pixel 0 of it is the middle of pixels 0 to factor - 1.
cv::Point2f in_full_size(cv::Point2f p, int factor) {
  const auto f = static_cast<float>(factor);
  const float middle = (f - 1) / 2;
  return f * p + cv::Point2f(middle, middle);
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
  const int factor = reduction(pair.size());
  const cv::Rect seen = with_margin(tile, factor * kTileMargin, pair.size());
  const View view = reduced(view_of(pair, of_match, seen), factor);
  std::vector<cv::KeyPoint> points;
  cv::Mat1f descriptors;
  const auto sift = cv::SIFT::create(count, 3, kContrast);
  sift->detectAndCompute(view.grey, view.usable, points, descriptors);
  KeyPoints found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const cv::Point2f at = in_full_size(points[i].pt, factor) + cv::Point2f(seen.tl());
    if (cv::Rect2f(tile).contains(at)) found.add(at, descriptors[static_cast<int>(i)]);
  }
  return found;
}

/// Where key points are looked for: everywhere, or in bands in the middle of equal parts.
std::vector<cv::Rect> places(cv::Size image) {
  if (pixels_of(image) <= kEnoughPixels) return image_parts(image, kTile);
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
  const int factor = reduction(size);
  return pixels / (factor * factor);
}

double key_point_bytes(cv::Size size, int threads) {
  // Six blurred images and five differences of them, of floats, of four times the pixels, and a
  // third more for the octaves: 235. Measured 236 for one tile to 276 for six of different sizes,
  // which leave holes in the heap.
  constexpr double kSiftBytesPerPixel = 255;
  constexpr double kViewBytesPerPixel = 2;  // grey levels and mask
  const std::vector<cv::Rect> tiles = places(size);
  const int factor = reduction(size);
  double largest = 0;
  for (const cv::Rect& tile : tiles) {
    largest = std::max(largest, double(with_margin(tile, factor * kTileMargin, size).area()));
  }
  const int at_once = std::min({threads, kTilesAtOnce, 2 * static_cast<int>(tiles.size())});
  const double reduced = (kViewBytesPerPixel + kSiftBytesPerPixel) / (factor * factor);
  return at_once * (factor > 1 ? reduced + kViewBytesPerPixel : reduced) * largest;
}

}  // namespace xgm::ransac_deskew
