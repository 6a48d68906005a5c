// SPDX-License-Identifier: Apache-2.0
// Generated stereo scenes whose truth is known exactly, with faults planted at will.
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

/// Rows that do not align: what a rectified pair would show at (x, y) of the match image is found
/// at (x, y + a * x + b * y + c) of the one delivered. Pixels; b > -1.
struct VerticalShift {
  double a = 0;
  double b = 0;
  double c = 0;

  double at(double x, double y) const { return a * x + b * y + c; }
};

/// What is wrong with a pair, in the order in which light meets it. As they are here, nothing is.
/// fault_kinds() has the ranges, and the strength that a fault has if none is given.
struct Faults {
  double weak_texture = 0;        ///< share of the contrast that is missing in parts of the scene
  double weak_share = 0.5;        ///< about this share of the scene is such a part
  double repetitive = 0;          ///< share of the texture that is the same pattern, repeated
  double repetitive_period = 12;  ///< px
  double shadow = 0;              ///< share of the light that is missing in parts of the match view
  double highlight = 0;           ///< reflections, elsewhere in either view; 1 = 255 grey levels
  double blur = 0;                ///< standard deviation, px; of the match view
  double vignetting = 0;          ///< share of the light that is missing in the corners
  double exposure = 1;            ///< of the match view: exposure * level + bias
  double bias = 0;                ///< grey levels
  double noise = 0;               ///< standard deviation in both views, grey levels
  double gamma = 1;               ///< of the match view: 255 * (level / 255)^gamma
  VerticalShift vertical;         ///< of the match view
};

/// One number of a fault.
struct FaultValue {
  std::string name;
  std::string unit;
  double planted = 0;                ///< if none is given
  double minimum = 0;                ///< inclusive
  double maximum = 0;                ///< inclusive
  double& (*in)(Faults&) = nullptr;  ///< where Faults keeps it
};

struct FaultKind {
  std::string name;
  std::string text;  ///< one sentence
  std::vector<FaultValue> values;
};

/// All that can be planted.
XGM_API const std::vector<FaultKind>& fault_kinds();

/// Adds one fault: "blur" (as strong as fault_kinds() says), "exposure=1.3", "vertical=0,0.01,1.3"
/// (values left out are as fault_kinds() says). Throws Error that says what is known, or in range.
XGM_API void plant(Faults& faults, const std::string& fault);

enum class Content {
  plain,  ///< flat rectangles and ellipses in one kind of texture before a slanted background
  rich,   ///< rooms of slanted and curved surfaces, thin structures, foliage, shading, patterns
};

struct Options {
  cv::Size size{640, 480};
  Interval disparities{0, 64};  ///< all surfaces lie in [begin, end - 1]; may be negative
  std::uint64_t seed = 1;       ///< another seed, another scene
  int objects = 12;             ///< before the background, 0 to 1000
  bool colour = true;           ///< three planes instead of one
  int bits = 8;                 ///< of the camera: 8 or 16; 0 leaves grey levels as computed
  Content content = Content::rich;
  /// A pixel sees through a lens with a Gaussian point spread of this standard deviation (px),
  /// sampled on samples x samples rays per pixel. 0 and 1: only what lies at its very centre.
  double lens = 0.55;
  int samples = 3;
  double sensor_noise = 0.7;  ///< that good cameras have, too; grey levels
  Faults faults;
};

/// A pair and all that is true of it. A pixel's truth is that of the surface which the ray through
/// its centre meets; rays of both views are intersected with the same surfaces, nothing is warped.
struct GeneratedScene {
  ImagePair pair;
  cv::Mat1f truth;                 ///< exact disparity of every base pixel
  cv::Mat1f reverse_truth;         ///< of every match pixel (x_base = x_match - d)
  cv::Mat1b non_occluded;          ///< 255 where a base pixel is seen in the match image, else 0
  cv::Mat1b reverse_non_occluded;  ///< 255 where a match pixel is seen in the base image, else 0
  Interval disparities;            ///< what a matcher has to search: as asked for
  Calibration calibration;         ///< of the base view, made up to suit
};

/// The same options give the same bytes on every machine and for any number of threads. Throws
/// Error if an option is out of its range.
XGM_API GeneratedScene generate(const Options& options);

/// Writes a scene folder in the layout of Middlebury V3: im0.png, im1.png, disp0GT.pfm and
/// disp1GT.pfm (both as positive numbers), mask0nocc.png and mask1nocc.png (255 seen in the other
/// view, 128 hidden), calib.txt, and scene.json with all options. calib.txt has an ndisp only if no
/// disparity is negative: nothing in it could say so. The folder appears when it is complete.
/// An older generated scene of that name is replaced, anything else is not. Throws Error.
XGM_API void write_scene(const std::string& folder, const GeneratedScene& scene,
                         const Options& options);

}  // namespace xgm::synthesis
