// SPDX-License-Identifier: Apache-2.0
#include "io/view_in_file.hpp"

#include <algorithm>

#include "io/warnings.hpp"
#include "xgm/data/image_parts.hpp"

namespace xgm {

RasterWindows::RasterWindows(const std::string& file, const std::vector<double>& no_data,
                             const std::string& scratch, std::optional<bool> alpha)
    : no_data_(no_data), windows_(open_stored(file, scratch)) {
  const StoredImage first = windows_->read({0, 0, 1, 1});
  stored_ = {file, windows_->size(), first.channels.front().depth()};
  planes_ = static_cast<int>(first.channels.size());
  alpha_ = !first.alpha.empty() && (alpha ? *alpha : is_alpha_filled_in());
}

StoredImage RasterWindows::read_stored(const cv::Rect& window) const {
  const std::lock_guard lock(reading_);
  return windows_->read(window);
}

bool RasterWindows::is_alpha_filled_in() const {
  const std::vector<cv::Rect> bands = row_bands(stored_.size);
  return std::any_of(bands.begin(), bands.end(), [&](const cv::Rect& band) {
    return cv::countNonZero(read_stored(band).alpha) > 0;
  });
}

UnscaledImage RasterWindows::read(const cv::Rect& window) const {
  return to_unscaled(read_stored(window), stored_.file, alpha_, no_data_);
}

ViewInFile::ViewInFile(const std::string& file, const std::string& mask_file,
                       const std::vector<double>& no_data, const std::string& scratch)
    : mask_file_(mask_file), scratch_(scratch), image_(file, no_data, scratch) {}

ViewInFile::ViewInFile(const std::string& file, const std::string& mask_file,
                       const std::vector<double>& no_data, const std::string& scratch,
                       const PairLook::View& look)
    : mask_file_(mask_file),
      scratch_(scratch),
      image_(file, no_data, scratch, look.alpha),
      marks_{look.never, look.marks},
      masked_pixels_(look.masked_pixels) {
  if (mask_file.empty()) return;
  mask_ =
      std::make_unique<RasterWindows>(mask_file, std::vector<double>{}, scratch, look.mask_alpha);
}

PairLook::View ViewInFile::look() const {
  return {.alpha = image_.has_alpha(),
          .mask_alpha = mask_ && mask_->has_alpha(),
          .never = marks_.never,
          .marks = marks_.values,
          .masked_pixels = masked_pixels_};
}

void ViewInFile::look_at_mask(std::vector<std::string>& warnings) {
  if (mask_file_.empty()) return;
  auto mask = std::make_unique<RasterWindows>(mask_file_, std::vector<double>{}, scratch_);
  const cv::Size size = mask->stored().size;
  MaskValues seen;
  for (const cv::Rect& band : row_bands(size)) seen.add(mask->read(band));
  append(warnings, seen.warnings(mask_file_, MaskUse::usable));
  require_mask_of(stored(), mask_file_, size);
  mask_ = std::move(mask);
}

void ViewInFile::look_for_marks(std::vector<std::string>& warnings) {
  const MarkedFile file{stored().file, stored().size, [&](const TakeImage& take) {
                          for (const cv::Rect& band : row_bands(stored().size)) {
                            UnscaledImage part = values(band);
                            take(part);
                          }
                        }};
  FoundMarks found = marks_of_image(file, stored().depth);
  append(warnings, found.warnings);
  marks_ = std::move(found.marks);
}

void ViewInFile::look_at_values(Extremes& extremes) {
  for (const cv::Rect& band : row_bands(stored().size)) {
    const UnscaledImage part = values(band);
    if (stored().depth != CV_8U) extremes.add(part);
    if (!part.valid.empty()) masked_pixels_ += band.area() - cv::countNonZero(part.valid);
  }
}

double ViewInFile::held_bytes() const {
  return image_.held_bytes() + (mask_ ? mask_->held_bytes() : 0);
}

std::optional<double> ViewInFile::masked_share() const {
  if (!mask_ && masked_pixels_ == 0) return std::nullopt;
  return masked_pixels_ / static_cast<double>(stored().size.area());
}

UnscaledImage ViewInFile::values(const cv::Rect& window) const {
  UnscaledImage raster = image_.read(window);
  if (mask_) apply_mask(raster, MaskValues().add(mask_->read(window)));
  mask(raster, marks_);
  return raster;
}

Image ViewInFile::read(const cv::Rect& window, const Scaling& scaling) const {
  UnscaledImage raster = values(window);
  if (masked_share() && raster.valid.empty()) raster.valid = cv::Mat1b(window.size(), 255);
  return to_image(std::move(raster), scaling);
}

}  // namespace xgm
