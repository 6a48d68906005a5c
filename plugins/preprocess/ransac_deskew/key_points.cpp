// SPDX-License-Identifier: Apache-2.0
#include "plugins/preprocess/ransac_deskew/key_points.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace xgm::ransac_deskew {
namespace {

// SIFT keeps some thirty floats per pixel. Tiles bound that for images of any size, and spread the
// key points over the image, which a linear model needs more than the very best ones.
constexpr int kTile = 1024;
constexpr int kTileMargin = 32;     // so that key points near a tile's border are not lost
constexpr int kSmallest = 16;       // pixels; nothing to find in less
constexpr double kContrast = 0.01;  // below SIFT's 0.04: dark images have key points, too, and the
                                    // count keeps the strongest
constexpr int kMaskMargin = 8;      // pixels; the edge of a mask is no feature of the scene

struct KeyPoints {
  std::vector<cv::Point2f> at;
  cv::Mat1f descriptors;  // one row each
};

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

/// Adds the key points that lie in `tile` itself, seen with a margin around it.
void detect_in_tile(const View& view, const cv::Rect& tile, cv::SIFT& sift, KeyPoints& found) {
  const cv::Rect seen = cv::Rect(tile.x - kTileMargin, tile.y - kTileMargin,
                                 tile.width + 2 * kTileMargin, tile.height + 2 * kTileMargin) &
                        cv::Rect({0, 0}, view.grey.size());
  std::vector<cv::KeyPoint> points;
  cv::Mat1f descriptors;
  sift.detectAndCompute(view.grey(seen), view.usable(seen), points, descriptors);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const cv::Point2f at = points[i].pt + cv::Point2f(seen.tl());
    if (!cv::Rect2f(tile).contains(at)) continue;
    found.at.push_back(at);
    found.descriptors.push_back(descriptors.row(static_cast<int>(i)));
  }
}

KeyPoints detect(const Image& image, int count) {
  KeyPoints found;
  const cv::Size size = image.size();
  if (std::min(size.width, size.height) < kSmallest) return found;
  const View view = prepare(image);
  const int columns = (size.width + kTile - 1) / kTile, rows = (size.height + kTile - 1) / kTile;
  const auto sift = cv::SIFT::create(std::max(1, count / (columns * rows)), 3, kContrast);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const cv::Point from(size.width * column / columns, size.height * row / rows);
      const cv::Point to(size.width * (column + 1) / columns, size.height * (row + 1) / rows);
      detect_in_tile(view, {from, to}, *sift, found);
    }
  }
  return found;
}

/// For each key point of `from` the best of `to`, or -1 if another is nearly as good.
std::vector<int> best_matches(const KeyPoints& from, const KeyPoints& to, double ratio) {
  std::vector<std::vector<cv::DMatch>> nearest;
  cv::BFMatcher(cv::NORM_L2).knnMatch(from.descriptors, to.descriptors, nearest, 2);
  std::vector<int> best(from.at.size(), -1);
  for (const auto& two : nearest)
    if (two.size() == 2 &&
        static_cast<double>(two[0].distance) < ratio * static_cast<double>(two[1].distance))
      best[static_cast<std::size_t>(two[0].queryIdx)] = two[0].trainIdx;
  return best;
}

}  // namespace

std::vector<Correspondence> match_key_points(const ImagePair& pair,
                                             const KeyPointOptions& options) {
  const KeyPoints base = detect(pair.base, options.count);
  const KeyPoints match = detect(pair.match, options.count);
  std::vector<Correspondence> found;
  if (base.at.size() < 2 || match.at.size() < 2) return found;
  const std::vector<int> there = best_matches(base, match, options.ratio);
  const std::vector<int> back = best_matches(match, base, options.ratio);
  for (std::size_t i = 0; i < there.size(); ++i) {
    if (there[i] < 0 || back[static_cast<std::size_t>(there[i])] != static_cast<int>(i)) continue;
    const cv::Point2d p = base.at[i], q = match.at[static_cast<std::size_t>(there[i])];
    if (std::abs(q.y - p.y) <= options.max_dy) found.push_back({q.x, p.y, q.y - p.y});
  }
  return found;
}

}  // namespace xgm::ransac_deskew
