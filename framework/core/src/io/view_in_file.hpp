// SPDX-License-Identifier: Apache-2.0
// One view of a pair, and its mask, in files that are read by windows.
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "io/grey_levels.hpp"
#include "io/marks.hpp"
#include "io/mask_values.hpp"
#include "io/stored_windows.hpp"
#include "xgm/io/pair_in_files.hpp"

namespace xgm {

/// Windows of what read_unscaled() gives, except that `valid` is empty where a window has no pixel
/// without data. Any thread may read.
class RasterWindows {
 public:
  /// `alpha`: whether an alpha channel is filled in, if that is known.
  RasterWindows(const std::string& file, const std::vector<double>& no_data,
                const std::string& scratch, std::optional<bool> alpha = std::nullopt);

  const Stored& stored() const { return stored_; }
  int planes() const { return planes_; }
  bool has_alpha() const { return alpha_; }
  double held_bytes() const { return windows_->held_bytes(); }

  UnscaledImage read(const cv::Rect& window) const;

 private:
  StoredImage read_stored(const cv::Rect& window) const;
  bool is_alpha_filled_in() const;

  std::vector<double> no_data_;
  std::unique_ptr<StoredWindows> windows_;
  mutable std::mutex reading_;
  Stored stored_;
  int planes_ = 1;
  bool alpha_ = false;
};

class ViewInFile {
 public:
  ViewInFile(const std::string& file, const std::string& mask_file,
             const std::vector<double>& no_data, const std::string& scratch);
  /// With what the looks below have found.
  ViewInFile(const std::string& file, const std::string& mask_file,
             const std::vector<double>& no_data, const std::string& scratch,
             const PairLook::View& look);
  PairLook::View look() const;

  /// In this order, before the first window is read. Throw Error, and add to the warnings.
  void look_at_mask(std::vector<std::string>& warnings);
  void look_for_marks(std::vector<std::string>& warnings);
  void look_at_values(Extremes& values);

  const Stored& stored() const { return image_.stored(); }
  int planes() const { return image_.planes(); }
  double held_bytes() const;
  std::optional<double> masked_share() const;

  Image read(const cv::Rect& window, const Scaling& scaling) const;

 private:
  UnscaledImage values(const cv::Rect& window) const;

  std::string mask_file_, scratch_;
  RasterWindows image_;
  std::unique_ptr<RasterWindows> mask_;
  Marks marks_;
  double masked_pixels_ = 0;
};

}  // namespace xgm
