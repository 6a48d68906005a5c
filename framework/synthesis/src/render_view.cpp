// SPDX-License-Identifier: Apache-2.0
// A camera without lens sees points; one with a lens sees weighted means of points around them,
// without which fine detail would turn into patterns that are not there.
#include <algorithm>
#include <cmath>

#include "render.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/synthesis/arithmetic.hpp"

namespace xgm::synthesis {
namespace {

constexpr int kBand = 32;  // rows rendered at once: those around it are rendered twice

/// Weights of the rays around a pixel, in one direction.
struct PointSpread {
  int samples = 1;  ///< rays per pixel
  int reach = 0;    ///< rays beyond the pixel's own, to either side
  std::vector<float> weights;

  PointSpread(int samples_per_pixel, double deviation) : samples(samples_per_pixel) {
    reach = static_cast<int>(std::ceil(3 * deviation * samples));
    double sum = 0;
    std::vector<double> exact;
    for (int k = -reach; k < samples + reach; ++k) {
      const double t = deviation > 0 ? offset(k) / deviation : 0;
      exact.push_back(exponential(-t * t / 2));
      sum += exact.back();
    }
    for (const double weight : exact) weights.push_back(static_cast<float>(weight / sum));
  }

  /// Where ray k of pixel 0 is, from the pixel's centre.
  double offset(int k) const { return (k + 0.5) / samples - 0.5; }
};

class View {
 public:
  View(const Surfaces& surfaces, const Options& options, bool match)
      : surfaces_(surfaces),
        shift_(options.faults.vertical),
        match_(match),
        size_(options.size),
        channels_(options.colour ? 3 : 1),
        spread_(options.samples, deviation(options, match)) {
    for (int c = 0; c < channels_; ++c) image_.planes.emplace_back(size_);
  }

  Image run() {
    parallel_for(0, (size_.height + kBand - 1) / kBand, [this](int band) {
      render(band * kBand, std::min(size_.height, (band + 1) * kBand));
    });
    return image_;
  }

 private:
  static double deviation(const Options& options, bool match) {
    const double blur = match ? options.faults.blur : 0;
    return std::sqrt(options.lens * options.lens + blur * blur);
  }

  void render(int first, int last) {
    const int n = spread_.samples;
    const int begin = first * n - spread_.reach, end = last * n + spread_.reach;
    std::vector<cv::Mat1f> rows;  // of rays, pixels wide
    for (int c = 0; c < channels_; ++c) rows.emplace_back(end - begin, size_.width);
    cv::Mat1f rays(channels_, size_.width * n + 2 * spread_.reach);
    for (int row = begin; row < end; ++row) {
      trace(spread_.offset(row), rays);
      for (int c = 0; c < channels_; ++c) gather_row(rays[c], rows[index(c)][row - begin]);
    }
    for (int c = 0; c < channels_; ++c)
      for (int y = first; y < last; ++y)
        gather_column(rows[index(c)], (y - first) * n, image_.planes[index(c)][y]);
  }

  static std::size_t index(int channel) { return static_cast<std::size_t>(channel); }

  void trace(double y, cv::Mat1f& rays) const {
    auto candidates = in_row(surfaces_, ray_of(match_, shift_, 0, y).y);
    const bool straight = !match_ || shift_.a == 0;
    for (int k = 0; k < rays.cols; ++k) {
      const Ray ray = ray_of(match_, shift_, spread_.offset(k - spread_.reach), y);
      const Sight sight = straight ? look(candidates, ray) : look(in_row(surfaces_, ray.y), ray);
      const Levels levels = sight.surface->colour(sight.hit, ray, channels_);
      for (int c = 0; c < channels_; ++c) rays(c, k) = static_cast<float>(levels[index(c)]);
    }
  }

  void gather_row(const float* rays, float* out) const {
    for (int x = 0; x < size_.width; ++x) {
      float sum = 0;
      for (std::size_t k = 0; k < spread_.weights.size(); ++k)
        sum += spread_.weights[k] * rays[static_cast<std::size_t>(x * spread_.samples) + k];
      out[x] = sum;
    }
  }

  void gather_column(const cv::Mat1f& rows, int first, float* out) const {
    std::fill(out, out + size_.width, 0.0F);
    for (std::size_t k = 0; k < spread_.weights.size(); ++k) {
      const float* row = rows[first + static_cast<int>(k)];
      for (int x = 0; x < size_.width; ++x) out[x] += spread_.weights[k] * row[x];
    }
  }

  const Surfaces& surfaces_;
  VerticalShift shift_;
  bool match_;
  cv::Size size_;
  int channels_;
  PointSpread spread_;
  Image image_;
};

}  // namespace

Image render_view(const Surfaces& surfaces, const Options& options, bool match) {
  return View(surfaces, options, match).run();
}

}  // namespace xgm::synthesis
