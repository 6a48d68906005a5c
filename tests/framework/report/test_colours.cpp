// SPDX-License-Identifier: Apache-2.0
// The page's colours can be told apart without seeing red or green.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "framework/report/page.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

using Rgb = std::array<double, 3>;
using Matrix = std::array<Rgb, 3>;

// Linear light. G. Machado, M. Oliveira, L. Fernandes: A physiologically-based model for simulation
// of color vision deficiency, IEEE TVCG 15(6), 2009, severity 1.
const Matrix kTypical{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
const Matrix kProtanopia{{{0.152286, 1.052583, -0.204868},
                          {0.114503, 0.786281, 0.099216},
                          {-0.003882, -0.048116, 1.051998}}};
const Matrix kDeuteranopia{{{0.367322, 0.860646, -0.227968},
                            {0.280085, 0.672501, 0.047413},
                            {-0.011820, 0.042940, 0.968881}}};

Rgb times(const Matrix& m, const Rgb& v) {
  Rgb result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[i] += m[i][k] * v[k];
  }
  return result;
}

/// CIELAB, D65, of sRGB as seen through `eye`.
Rgb lab(const Rgb& srgb, const Matrix& eye) {
  Rgb linear{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = srgb[i] / 255;
    linear[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  Rgb xyz = times({{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}},
                  times(eye, linear));
  const Rgb white{0.9505, 1, 1.089};
  const auto f = [](double t) {
    return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  };
  for (std::size_t i = 0; i < 3; ++i) xyz[i] = f(std::max(0.0, xyz[i]) / white[i]);
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Rgb from_css(const std::string& css) {
  const auto part = [&](std::size_t at) {
    return double(std::stoi(css.substr(at, 2), nullptr, 16));
  };
  return {part(1), part(3), part(5)};
}

}  // namespace

TEST_CASE("report: the classes of a map differ in every kind of eye") {
  const auto data = page_data(report_html({"t", "", {}}));
  constexpr double kDistinct = 15;  // of CIELAB; 2.3 is just noticeable side by side
  for (const char* classes : {"statuses", "verdicts"}) {
    for (const Matrix& eye : {kTypical, kProtanopia, kDeuteranopia}) {
      const auto& all = data[classes];
      for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
          CAPTURE(all[i]["name"].get<std::string>() + ", " + all[k]["name"].get<std::string>());
          const Rgb a = lab(from_css(all[i]["colour"]), eye);
          const Rgb b = lab(from_css(all[k]["colour"]), eye);
          CHECK(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) > kDistinct);
        }
      }
    }
  }
}

TEST_CASE("report: ramps become lighter all the way, in every kind of eye") {
  const auto ramps = page_data(report_html({"t", "", {}}))["ramps"];
  constexpr std::size_t kApart = 8;  // neighbours are one rounding of 8 bit apart
  for (const char* ramp : {"disparity", "error"}) {
    for (const Matrix& eye : {kTypical, kProtanopia, kDeuteranopia}) {
      for (std::size_t i = kApart; i < 256; ++i) {
        CAPTURE(i);
        CHECK(lab(ramps[ramp][i].get<Rgb>(), eye)[0] >
              lab(ramps[ramp][i - kApart].get<Rgb>(), eye)[0]);
      }
    }
  }
}
