// SPDX-License-Identifier: Apache-2.0
// The numbers of an RPC camera, as vendors deliver them.
#pragma once

#include <array>

namespace xgm::geo {

/// What maps [offset - scale, offset + scale] to [-1, 1].
struct RpcAxis {
  double offset = 0;
  double scale = 1;

  double normalised(double value) const { return (value - offset) / scale; }
  double value(double normalised) const { return normalised * scale + offset; }
};

/// Coefficients of 1, L, P, H, LP, LH, PH, L2, P2, H2, PLH, L3, LP2, LH2, L2P, P3, PH2, L2H, P2H,
/// H3, where L, P and H are the normalised longitude, latitude and height (RPC00B of NIMA: The
/// compendium of controlled extensions for the NITF, STDI-0002).
using RpcPolynomial = std::array<double, 20>;

/// Quotient of two polynomials.
struct RpcRatio {
  RpcPolynomial numerator{};
  RpcPolynomial denominator{};
};

/// Rational polynomial coefficients: from the ground to a pixel. Columns are also called samples,
/// rows lines. Pixel (0, 0) is the centre of the first pixel, for every format that is read.
struct RpcModel {
  RpcAxis column, row;          ///< px
  RpcAxis longitude, latitude;  ///< degrees
  RpcAxis height;               ///< m above the WGS 84 ellipsoid
  RpcRatio column_ratio, row_ratio;
};

}  // namespace xgm::geo
