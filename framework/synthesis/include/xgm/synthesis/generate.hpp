// SPDX-License-Identifier: Apache-2.0
// Generates stereo scenes with exact ground truth, with image faults planted on request.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/calibration.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/data/image.hpp"

namespace xgm::synthesis {

/// A vertical misalignment: what a rectified pair would show at (x, y) of the match image appears
/// at (x, y + a * x + b * y + c) of the generated one. In pixels; b > -1.
struct VerticalShift {
  double a = 0;
  double b = 0;
  double c = 0;

  double at(double x, double y) const { return a * x + b * y + c; }
};

/// Faults planted in a pair, in the order in which they are applied. The defaults plant none.
/// fault_kinds() has the ranges, and the strengths of faults that are planted without values.
struct Faults {
  double weak_texture = 0;        ///< fraction of the contrast that parts of the scene lose
  double weak_share = 0.5;        ///< approximate share of these parts of the scene
  double repetitive = 0;          ///< fraction of the texture that is a repeated pattern
  double repetitive_period = 12;  ///< px
  double shadow = 0;              ///< fraction of the light that parts of the match view lose
  double highlight = 0;    ///< reflections, at different places per view; 1 = 255 grey levels
  double blur = 0;         ///< standard deviation, px; of the match view
  double vignetting = 0;   ///< fraction of the light that the corners lose
  double exposure = 1;     ///< of the match view: exposure * level + bias
  double bias = 0;         ///< grey levels
  double noise = 0;        ///< standard deviation in both views, grey levels
  double gamma = 1;        ///< of the match view: 255 * (level / 255)^gamma
  VerticalShift vertical;  ///< of the match view
};

/// One parameter of a fault.
struct FaultValue {
  std::string name;
  std::string unit;
  double planted = 0;                ///< value if none is given
  double minimum = 0;                ///< inclusive
  double maximum = 0;                ///< inclusive
  double& (*in)(Faults&) = nullptr;  ///< its member of Faults
};

struct FaultKind {
  std::string name;
  std::string text;  ///< one sentence
  std::vector<FaultValue> values;
};

/// All kinds of faults.
XGM_API const std::vector<FaultKind>& fault_kinds();

/// Adds one fault: "blur", "exposure=1.3", "vertical=0,0.01,1.3". Values that are left out are
/// taken from fault_kinds(). Throws Error that lists the known faults, or the allowed range.
XGM_API void plant(Faults& faults, const std::string& fault);

enum class Content {
  plain,  ///< flat rectangles and ellipses with one kind of texture in front of a slanted plane
  rich,   ///< rooms of slanted and curved surfaces, thin structures, foliage, shading, patterns
};

struct Options {
  cv::Size size{640, 480};
  Interval disparities{0, 64};  ///< all surfaces lie in [begin, end - 1]; may be negative
  std::uint64_t seed = 1;       ///< each seed gives another scene
  int objects = 12;             ///< in front of the background, 0 to 1000
  bool colour = true;           ///< three planes instead of one
  int bits = 8;                 ///< of the camera: 8 or 16; 0: grey levels are not rounded
  Content content = Content::rich;
  /// The lens has a Gaussian point spread function of this standard deviation (px), sampled by
  /// samples x samples rays per pixel. With 0 and 1, a pixel shows only the point at its centre.
  double lens = 0.55;
  int samples = 3;
  double sensor_noise = 0.7;  ///< noise of a good camera, grey levels
  Faults faults;
};

/// A pair and its ground truth. The truth of a pixel is that of the surface that the ray through
/// its centre meets. Rays of both views are intersected with the same surfaces; no image is warped.
struct GeneratedScene {
  ImagePair pair;
  cv::Mat1f truth;                 ///< exact disparity of every base pixel
  cv::Mat1f reverse_truth;         ///< of every match pixel (x_base = x_match - d)
  cv::Mat1b non_occluded;          ///< 255 where a base pixel is visible in the match image, else 0
  cv::Mat1b reverse_non_occluded;  ///< 255 where a match pixel is visible in the base image, else 0
  Interval disparities;            ///< the range to search, as requested
  Calibration calibration;         ///< invented, consistent with the disparities
};

/// The same options give the same bytes on every machine and for any number of threads. Throws
/// Error if an option is out of its range.
XGM_API GeneratedScene generate(const Options& options);

/// Writes a scene folder in the layout of Middlebury V3: im0.png, im1.png, disp0GT.pfm and
/// disp1GT.pfm (both as positive numbers), mask0nocc.png and mask1nocc.png (255 visible in the
/// other view, 128 hidden), calib.txt, and scene.json with all options. calib.txt has ndisp only if
/// no disparity is negative, because it cannot express a negative range. The folder appears when it
/// is complete. An existing generated scene of that name is replaced; other folders are not. Throws
/// Error.
XGM_API void write_scene(const std::string& folder, const GeneratedScene& scene,
                         const Options& options);

}  // namespace xgm::synthesis
