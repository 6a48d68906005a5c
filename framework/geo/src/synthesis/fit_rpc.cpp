// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/synthesis/fit_rpc.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "camera/rpc_polynomials.hpp"

namespace xgm::geo {
namespace {

constexpr int kPlaces = 21;  // in each direction of the image
constexpr int kHeights = 9;
constexpr double kBeyond = 0.05;  // of the image's size that the grid reaches beyond it
constexpr int kRounds = 5;
constexpr int kTerms = 20, kUnknowns = 2 * kTerms - 1;  // the denominator's first one is 1
constexpr double kRegularisation = 1e-9;

struct Sample {
  cv::Point2d pixel;
  GeoPoint point;
};

/// `shift` is a share of the grid's step, by which all of it is moved inwards.
std::vector<Sample> sample(cv::Size image, const HeightInterval& heights,
                           const GroundOfPixel& ground, double shift) {
  const auto at = [&](int i, int count, double low, double high) {
    return low + (high - low) * std::min(i + shift, count - 1.0) / (count - 1);
  };
  std::vector<Sample> samples;
  for (int k = 0; k < kPlaces * kPlaces * kHeights; ++k) {
    const double w = image.width * kBeyond, h = image.height * kBeyond;
    const cv::Point2d pixel(at(k % kPlaces, kPlaces, -w, image.width - 1 + w),
                            at(k / kPlaces % kPlaces, kPlaces, -h, image.height - 1 + h));
    const double height = at(k / kPlaces / kPlaces, kHeights, heights.min, heights.max);
    samples.push_back({pixel, ground(pixel, height)});
  }
  return samples;
}

template <class Value>
RpcAxis axis_of(const std::vector<Sample>& samples, const Value& value) {
  double low = INFINITY, high = -INFINITY;
  for (const Sample& sample : samples) {
    low = std::min(low, value(sample));
    high = std::max(high, value(sample));
  }
  return {(low + high) / 2, (high - low) / 2};
}

/// numerator - value * denominator = 0 for all samples.
RpcRatio fit_ratio(const std::vector<RpcTerms>& terms, const std::vector<double>& values) {
  const auto n = static_cast<Eigen::Index>(terms.size());
  RpcRatio ratio;
  ratio.denominator[0] = 1;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n + kUnknowns, kUnknowns);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n + kUnknowns);
    for (Eigen::Index i = 0; i < n; ++i) {
      const RpcTerms& t = terms[static_cast<std::size_t>(i)];
      const double value = values[static_cast<std::size_t>(i)];
      const double weight = 1 / dot(ratio.denominator, t);
      for (int k = 0; k < kTerms; ++k) a(i, k) = weight * t[static_cast<std::size_t>(k)];
      for (int k = 1; k < kTerms; ++k) {
        a(i, kTerms - 1 + k) = -weight * value * t[static_cast<std::size_t>(k)];
      }
      b(i) = weight * value;
    }
    a.bottomRows(kUnknowns).diagonal().setConstant(kRegularisation *
                                                   std::sqrt(static_cast<double>(n)));
    const Eigen::VectorXd x = a.householderQr().solve(b);
    for (int k = 0; k < kTerms; ++k) ratio.numerator[static_cast<std::size_t>(k)] = x(k);
    for (int k = 1; k < kTerms; ++k) {
      ratio.denominator[static_cast<std::size_t>(k)] = x(kTerms - 1 + k);
    }
  }
  return ratio;
}

}  // namespace

RpcFit fit_rpc(cv::Size image, const HeightInterval& heights, const GroundOfPixel& ground) {
  const std::vector<Sample> samples = sample(image, heights, ground, 0);
  RpcFit fit;
  RpcModel& model = fit.model;
  model.column = axis_of(samples, [](const Sample& s) { return s.pixel.x; });
  model.row = axis_of(samples, [](const Sample& s) { return s.pixel.y; });
  model.longitude = axis_of(samples, [](const Sample& s) { return s.point.longitude; });
  model.latitude = axis_of(samples, [](const Sample& s) { return s.point.latitude; });
  model.height = axis_of(samples, [](const Sample& s) { return s.point.height; });
  std::vector<RpcTerms> terms;
  std::vector<double> columns, rows;
  for (const Sample& s : samples) {
    terms.push_back(rpc_terms(model.longitude.normalised(s.point.longitude),
                              model.latitude.normalised(s.point.latitude),
                              model.height.normalised(s.point.height)));
    columns.push_back(model.column.normalised(s.pixel.x));
    rows.push_back(model.row.normalised(s.pixel.y));
  }
  model.column_ratio = fit_ratio(terms, columns);
  model.row_ratio = fit_ratio(terms, rows);
  const RpcCamera camera(model);
  for (const Sample& s : sample(image, heights, ground, 0.5)) {
    fit.residual = std::max(fit.residual, cv::norm(camera.project(s.point) - s.pixel));
  }
  return fit;
}

}  // namespace xgm::geo
