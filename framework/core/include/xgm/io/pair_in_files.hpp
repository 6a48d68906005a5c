// SPDX-License-Identifier: Apache-2.0
// A pair of image files that is read by windows.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/pair_windows.hpp"
#include "xgm/data/scene_files.hpp"

namespace xgm {

/// What a look at all pixels of a pair has found: what its windows need to know of the rest.
struct PairLook {
  struct View {
    bool alpha = false, mask_alpha = false;  ///< whether an alpha channel is filled in
    /// Larger values than this, and these values, mean no data.
    double never = std::numeric_limits<double>::infinity();
    std::vector<double> marks{};
    double masked_pixels = 0;
  };
  View left{}, right{};
  double offset = 0, gain = 1;  ///< grey level = (value - offset) * gain
};

/// What read_pair() reads, by windows of the same values, notes and warnings. TIFF is read strip by
/// strip or tile by tile, as long as none has more than 64 MB; PNG is decoded once, as far as
/// windows reach, into a file without name, unless it is interlaced, has a palette or less than 8
/// bits; all else is held in memory as it is stored.
class XGM_API PairInFiles final : public PairWindows {
 public:
  /// Looks at all pixels once or twice: for damages, what the values range over and what means no
  /// data. Temporary files are made in the folder `scratch`. Throws Error as read_pair() does.
  PairInFiles(const PairFiles& files, const std::string& scratch);
  /// Looks at nothing, has no notes and no warnings: `look` is that of the same files.
  PairInFiles(const PairFiles& files, const std::string& scratch, const PairLook& look);
  ~PairInFiles() override;

  cv::Size size() const override;
  /// Throws Error, also if a file was changed meanwhile.
  ImagePair read(const cv::Rect& window) const override;

  const std::vector<std::string>& notes() const { return notes_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// Share of pixels without data, if there are any or a mask was given.
  std::optional<double> masked_share(bool of_match) const;
  PairLook look() const;
  /// Bytes of memory that are held from one window to the next.
  double held_bytes() const;

 private:
  struct Files;
  std::unique_ptr<Files> files_;
  std::vector<std::string> notes_, warnings_;
};

}  // namespace xgm
