// SPDX-License-Identifier: Apache-2.0
// Values and derivatives of the rational polynomials.
#pragma once

#include "xgm/geo/camera/rpc_model.hpp"

namespace xgm::geo {

/// The 20 terms at a place, or their derivatives.
using RpcTerms = std::array<double, 20>;

inline RpcTerms rpc_terms(double l, double p, double h) {
  return {1,         l,         p,         h,         l * p,     l * h,     p * h,
          l * l,     p * p,     h * h,     p * l * h, l * l * l, l * p * p, l * h * h,
          l * l * p, p * p * p, p * h * h, l * l * h, p * p * h, h * h * h};
}

inline RpcTerms rpc_terms_by_longitude(double l, double p, double h) {
  return {0,     1,         0,     0,     p,         h, 0, 2 * l,     0, 0,
          p * h, 3 * l * l, p * p, h * h, 2 * l * p, 0, 0, 2 * l * h, 0, 0};
}

inline RpcTerms rpc_terms_by_latitude(double l, double p, double h) {
  return {0,     0, 1,         0, l,     0,         h,     0, 2 * p,     0,
          l * h, 0, 2 * l * p, 0, l * l, 3 * p * p, h * h, 0, 2 * p * h, 0};
}

inline double dot(const RpcPolynomial& polynomial, const RpcTerms& terms) {
  double sum = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) sum += polynomial[i] * terms[i];
  return sum;
}

inline double value(const RpcRatio& ratio, const RpcTerms& terms) {
  return dot(ratio.numerator, terms) / dot(ratio.denominator, terms);
}

/// Of the quotient, given its value and the derivatives of the terms.
inline double derivative(const RpcRatio& ratio, const RpcTerms& terms, const RpcTerms& derivatives,
                         double value) {
  return (dot(ratio.numerator, derivatives) - value * dot(ratio.denominator, derivatives)) /
         dot(ratio.denominator, terms);
}

}  // namespace xgm::geo
