// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/map_in_parts.hpp"

#include <filesystem>

#include "io/pfm_in_parts.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/write_maps.hpp"

namespace xgm {
namespace {

constexpr double kMapBytes = sizeof(float) + 1;

std::string in(const std::string& folder, const char* name) {
  return (std::filesystem::path(folder) / name).string();
}

Sampling sampling_of(cv::Size size, double pixels) {
  const Sampling usual = Sampling::of_picture(size);
  return usual.shown().area() <= pixels ? usual : Sampling::within(size, pixels);
}

/// The pixels of a picture that show some of [begin, end), and maybe some beside them.
cv::Range shown_near(int begin, int end, int stride, int shown) {
  return {std::max(0, begin / stride - 1), std::min(shown, end / stride + 1)};
}

}  // namespace

struct MapInParts::Pfm : PfmInParts {
  using PfmInParts::PfmInParts;
};

MapInParts::MapInParts(const std::string& folder, cv::Size size, Interval searched,
                       double picture_pixels)
    : folder_(folder),
      size_(size),
      pfm_(std::make_unique<Pfm>(in(folder, kMapFiles[0]), size)),
      summary_(searched),
      sampling_(sampling_of(size, picture_pixels)),
      shown_(sampling_.shown()) {}

MapInParts::~MapInParts() = default;

void MapInParts::take(const cv::Rect& place, const DisparityMap& part) {
  pfm_->put(place, part.disparity);
  if (!part.confidence.empty()) {
    if (!confidence_) confidence_ = std::make_unique<Pfm>(in(folder_, kConfidenceFile), size_);
    confidence_->put(place, part.confidence);
  }
  summary_.add(part);
  const cv::Size shown = sampling_.shown();
  const cv::Range rows = shown_near(place.y, place.br().y, sampling_.stride, shown.height);
  const cv::Range columns = shown_near(place.x, place.br().x, sampling_.stride, shown.width);
  for (int y = rows.start; y < rows.end; ++y) {
    for (int x = columns.start; x < columns.end; ++x) {
      const cv::Point pixel = sampling_.at(x, y);
      if (!place.contains(pixel)) continue;
      const cv::Point within = pixel - place.tl();
      shown_.set(y, x, part.disparity(within), part.at(within.y, within.x));
    }
  }
}

void MapInParts::finish() {
  pfm_->finish();
  write_png(in(folder_, kMapFiles[1]), summary_.density() > 0
                                           ? colour_picture(shown_.disparity, "px")
                                           : disparity_picture(shown_));
  write_png(in(folder_, kMapFiles[2]), status_picture(shown_, summary_.status_shares()));
  if (confidence_) {
    confidence_->finish();
  } else {
    remove_file(in(folder_, kConfidenceFile));
  }
}

double MapInParts::held_bytes(cv::Size size, double picture_pixels) {
  return kMapBytes * sampling_of(size, picture_pixels).shown().area();
}

double MapInParts::finish_bytes(cv::Size size, double picture_pixels) {
  return bytes_to_draw(sampling_of(size, picture_pixels).shown());
}

double MapInParts::picture_pixels(double bytes) {
  const cv::Size some(1000, 1000);
  return bytes * some.area() / (kMapBytes * some.area() + bytes_to_draw(some));
}

}  // namespace xgm
