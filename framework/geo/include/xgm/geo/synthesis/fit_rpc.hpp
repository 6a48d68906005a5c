// SPDX-License-Identifier: Apache-2.0
// Rational polynomials for a camera of another kind.
#pragma once

#include <functional>

#include "xgm/geo/camera/rpc_camera.hpp"

namespace xgm::geo {

/// Where a pixel is seen on the ground at a height above the ellipsoid, m.
using GroundOfPixel = std::function<GeoPoint(cv::Point2d pixel, double height)>;

struct RpcFit {
  RpcModel model;
  double residual = 0;  ///< largest distance between both cameras, px, at other points than fitted
};

/// Least squares on a grid of pixels and heights that reaches somewhat beyond the image, reweighted
/// by the denominators, with a little regularisation. Tao, Hu: A comprehensive study of the
/// rational function model for photogrammetric processing (PE&RS 2001), Eq. 6 to 13.
XGM_API RpcFit fit_rpc(cv::Size image, const HeightInterval& heights, const GroundOfPixel& ground);

}  // namespace xgm::geo
