// SPDX-License-Identifier: Apache-2.0
// OpenCV's semi-global matcher, so that a well-known peer runs in our pipelines and tables.
#include <algorithm>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <string>

#include "plugins/matcher/opencv_sgbm/convert.hpp"
#include "xgm/plugin.hpp"

namespace {

using Mode = int;  // as cv::StereoSGBM has it

/// Calls cv::StereoSGBM. It needs one interval for the whole image; its number of disparities is
/// rounded up to a multiple of 16. OpenCV does not say why it rejects a pixel: most of them fail
/// its left-right check, which cannot be switched off, so they are reported as mismatched. A run
/// that is cancelled during the call ends after it: OpenCV cannot be interrupted (6 megapixels and
/// 288 disparities take it 4.7 s).
class OpenCvSgbm final : public xgm::Matcher, public xgm::StatesNeeds {
 public:
  struct Parameters {
    Mode mode = cv::StereoSGBM::MODE_SGBM;
    int block_size = 3;
    int p1 = 8 * 3 * 9;
    int p2 = 32 * 3 * 9;
    int disp12_max_diff = 1;
    int pre_filter_cap = 63;  // as in OpenCV's samples
    int uniqueness_ratio = 0;
    int speckle_window_size = 0;
    int speckle_range = 0;
    bool pad = true;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set);

  explicit OpenCvSgbm(Parameters parameters) : parameters_(parameters) {}

  bool accepts_range_maps() const override { return false; }

  xgm::MatchResult run(const xgm::MatchRequest& request, const xgm::Context&) const override {
    if (!request.range.is_uniform()) {
      throw xgm::Error(
          "OpenCV's matcher needs one search range for the whole image; give one interval instead "
          "of range maps");
    }
    const xgm::Interval asked = request.range.hull();
    if (asked.empty()) return unmatched(request.pair);
    const xgm::Interval searched{asked.begin, asked.begin + (asked.size() + 15) / 16 * 16};
    check(searched);
    return match(request.pair, asked, searched);
  }

  /// With all 8 paths, or 4 in both directions, OpenCV keeps 16-bit costs and sums of all pixels.
  xgm::Needs needs(const xgm::Workload& load) const override {
    const bool full =
        parameters_.mode == cv::StereoSGBM::MODE_HH || parameters_.mode == cv::StereoSGBM::MODE_HH4;
    constexpr double kBytesPerPixel = 16;  // images of 8 bit, sixteenths of disparities
    return {.working = kBytesPerPixel * load.pixels() + (full ? 4 * load.cells() : 0),
            .updates = load.cells(),
            .moved = full ? 12 * load.cells() : 0};
  }

 private:
  /// OpenCV holds sixteenths of a pixel in 16 bits, and one value below the range for "invalid".
  static void check(xgm::Interval searched) {
    if (searched.begin > -2048 && searched.end <= 2047) return;
    throw xgm::Error(
        "OpenCV's matcher knows disparities from -2047 to 2046 only, but would search " +
        std::to_string(searched.begin) + " to " + std::to_string(searched.end - 1) +
        "; narrow the search range or use another matcher");
  }

  /// OpenCV's removal of speckles holds columns and rows in 16 bits, and writes beyond its memory
  /// if there are more.
  void check_sides(cv::Size padded) const {
    constexpr int kMax = std::numeric_limits<short>::max();
    if (parameters_.speckle_window_size == 0 || std::max(padded.width, padded.height) <= kMax)
      return;
    throw xgm::Error("OpenCV's removal of speckles takes images of up to " + std::to_string(kMax) +
                     " px to a side, but these have " + std::to_string(padded.width) + " x " +
                     std::to_string(padded.height) +
                     " with the search range; set speckle_window_size to 0, and let the filter "
                     "peak_removal do it");
  }

  xgm::MatchResult match(const xgm::ImagePair& pair, xgm::Interval asked,
                         xgm::Interval searched) const {
    namespace cvt = xgm::opencv_sgbm;
    const cvt::Padding needed = cvt::skipped_columns(searched);
    const cvt::Padding padding = parameters_.pad ? needed : cvt::Padding{};
    const cvt::Padding skipped = parameters_.pad ? cvt::Padding{} : needed;
    const cv::Size size = pair.size();
    const int usable_width = size.width - skipped.left - skipped.right;
    // OpenCV's result depends on memory that it never set where less than a block is left.
    if (std::min(usable_width, size.height) < parameters_.block_size) return unmatched(pair);

    check_sides({size.width + padding.left + padding.right, size.height});
    cv::Mat1s sixteenths;
    matcher(searched)->compute(cvt::to_8bit(pair.base, padding), cvt::to_8bit(pair.match, padding),
                               sixteenths);
    const cv::Rect unpadded({padding.left, 0}, size);
    const cvt::Meaning meaning{searched, asked, skipped, xgm::Status::mismatched};
    return {cvt::from_sixteenths(sixteenths(unpadded), pair, meaning), std::nullopt};
  }

  cv::Ptr<cv::StereoSGBM> matcher(xgm::Interval searched) const {
    const Parameters& p = parameters_;
    return cv::StereoSGBM::create(searched.begin, searched.size(), p.block_size, p.p1, p.p2,
                                  p.disp12_max_diff, p.pre_filter_cap, p.uniqueness_ratio,
                                  p.speckle_window_size, p.speckle_range, p.mode);
  }

  static xgm::MatchResult unmatched(const xgm::ImagePair& pair) {
    xgm::DisparityMap map(pair.size(), xgm::Status::out_of_range);
    if (!pair.base.valid.empty()) {
      map.status.setTo(static_cast<int>(xgm::Status::masked), pair.base.valid == 0);
    }
    return {map, std::nullopt};
  }

  Parameters parameters_;
};

void OpenCvSgbm::describe(Parameters& p, xgm::ParameterSet& set) {
  set.add_choice<Mode>("mode", p.mode, "Path directions: sgbm has 5, hh 8, sgbm_3way 3, hh4 4.",
                       {{"sgbm", cv::StereoSGBM::MODE_SGBM},
                        {"hh", cv::StereoSGBM::MODE_HH},
                        {"sgbm_3way", cv::StereoSGBM::MODE_SGBM_3WAY},
                        {"hh4", cv::StereoSGBM::MODE_HH4}});
  set.add("block_size", p.block_size, "Side of the blocks whose costs are summed up.")
      .unit("px")
      .range(1, 11)
      .odd();
  set.add("p1", p.p1,
          "Penalty of a disparity step of one; OpenCV advises 8 * channels * block_size^2.")
      .range(1, 32766);
  set.add("p2", p.p2,
          "Penalty of larger disparity steps; OpenCV advises 32 * channels * block_size^2.")
      .range(2, 32767);
  set.add("disp12_max_diff", p.disp12_max_diff,
          "Largest difference of the two views' disparities in the left-right check.")
      .unit("px")
      .range(1, 1024);
  set.add("pre_filter_cap", p.pre_filter_cap, "Horizontal gradients are cut to this size.")
      .unit("grey levels")
      .range(15, 127);
  set.add("uniqueness_ratio", p.uniqueness_ratio,
          "By how much the best cost must beat the second best.")
      .unit("%")
      .range(0, 100);
  set.add("speckle_window_size", p.speckle_window_size,
          "Segments of up to this many pixels are removed; 0 keeps all.")
      .unit("px")
      .range(0, 1000000);
  set.add("speckle_range", p.speckle_range, "Largest disparity step inside a segment.")
      .unit("px")
      .range(0, 1024);
  set.add("pad", p.pad,
          "Widen the images by the search range, so that the columns that OpenCV would skip at the "
          "border are matched too.");
  set.rule({"p2", "p1"}, "must be larger than p1", [&p] { return p.p1 < p.p2; });
}

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<OpenCvSgbm>("opencv_sgbm",
                           "OpenCV's semi-global block matching (cv::StereoSGBM) as a matcher.",
                           "OpenCV, calib3d module: cv::StereoSGBM, after H. Hirschmueller, IEEE "
                           "TPAMI 30(2), 2008.");
}
