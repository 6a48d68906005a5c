// SPDX-License-Identifier: Apache-2.0
#include "xgm/synthesis/arithmetic.hpp"

#include <algorithm>
#include <cmath>

#include "xgm/base/random.hpp"

namespace xgm::synthesis {
namespace {

constexpr double kLn2 = 0.69314718055994530942;

/// For t > 0: with t = m * 2^e and m about 1, ln m = 2 artanh((m - 1) / (m + 1)), whose series
/// needs few terms.
double natural_logarithm(double t) {
  int exponent = 0;
  double m = std::frexp(t, &exponent);
  if (m < 0.70710678118654752440) {
    m *= 2;
    --exponent;
  }
  const double z = (m - 1) / (m + 1);
  double sum = 0;
  for (int k = 23; k >= 1; k -= 2) sum = sum * z * z + 1.0 / k;
  return 2 * z * sum + exponent * kLn2;
}

double lattice(std::uint64_t row_key, std::int64_t x, std::int64_t y) {
  using namespace random_bits;
  return unit(mix(mix(row_key ^ static_cast<std::uint64_t>(x)) ^ static_cast<std::uint64_t>(y)));
}

}  // namespace

double exponential(double x) {
  const double whole = std::floor(x / kLn2 + 0.5);
  const double rest = x - whole * kLn2;
  double sum = 1;
  for (int k = 17; k >= 1; --k) sum = 1 + rest * sum / k;
  return std::ldexp(sum, static_cast<int>(whole));
}

double power(double t, double exponent) {
  return t <= 0 ? 0 : exponential(exponent * natural_logarithm(t));
}

double smooth_step(double t) {
  const double s = std::clamp(t, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

double value_noise(std::uint64_t key, double x, double y) {
  const double x0 = std::floor(x), y0 = std::floor(y);
  const auto i = static_cast<std::int64_t>(x0), j = static_cast<std::int64_t>(y0);
  const double s = smooth_step(x - x0), t = smooth_step(y - y0);
  const double above = lattice(key, i, j) * (1 - s) + lattice(key, i + 1, j) * s;
  const double below = lattice(key, i, j + 1) * (1 - s) + lattice(key, i + 1, j + 1) * s;
  return above * (1 - t) + below * t;
}

}  // namespace xgm::synthesis
