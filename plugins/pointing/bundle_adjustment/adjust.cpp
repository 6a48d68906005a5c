// SPDX-License-Identifier: Apache-2.0
#include "plugins/pointing/bundle_adjustment/adjust.hpp"

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/sized_cost_function.h>
#include <ceres/solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "xgm/base/error.hpp"
#include "xgm/geo/camera/meeting.hpp"

namespace xgm::geo {
namespace {

/// A point of the ground, moved by metres to the east, to the north and up.
class GroundPoint {
 public:
  explicit GroundPoint(const GeoPoint& start) : start_(start) {
    const cv::Matx33d axes = local_axes(start);
    const cv::Vec3d here = to_ecef(start);
    constexpr double kStep = 10;  // m
    const GeoPoint moved =
        to_geodetic(here + kStep * (axes * cv::Vec3d(1, 0, 0) + axes * cv::Vec3d(0, 1, 0)));
    per_metre_ = {(moved.longitude - start.longitude) / kStep,
                  (moved.latitude - start.latitude) / kStep};
  }
  GeoPoint at(const double* move) const {
    return {start_.longitude + per_metre_.x * move[0], start_.latitude + per_metre_.y * move[1],
            start_.height + move[2]};
  }

 private:
  GeoPoint start_;
  cv::Point2d per_metre_;  // degrees
};

/// Where a point is seen, less where it was seen, px.
class Reprojection final : public ceres::SizedCostFunction<2, 2, 3> {
 public:
  Reprojection(const RpcCamera& camera, const GroundPoint& point, cv::Point2d seen)
      : camera_(camera), point_(point), seen_(seen) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const double *const bias = parameters[0], *const move = parameters[1];
    const cv::Point2d pixel = camera_.project(point_.at(move));
    residuals[0] = pixel.x + bias[0] - seen_.x;
    residuals[1] = pixel.y + bias[1] - seen_.y;
    if (!std::isfinite(residuals[0]) || !std::isfinite(residuals[1])) return false;
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) std::ranges::copy(std::array{1.0, 0.0, 0.0, 1.0}, jacobians[0]);
    if (jacobians[1] == nullptr) return true;
    for (int k = 0; k < 3; ++k) {
      constexpr double kStep = 1;  // m; cameras are linear over it
      std::array<double, 3> low{move[0], move[1], move[2]}, high = low;
      low[static_cast<std::size_t>(k)] -= kStep;
      high[static_cast<std::size_t>(k)] += kStep;
      const cv::Point2d slope =
          (camera_.project(point_.at(high.data())) - camera_.project(point_.at(low.data()))) /
          (2 * kStep);
      jacobians[1][k] = slope.x;
      jacobians[1][3 + k] = slope.y;
    }
    return true;
  }

 private:
  const RpcCamera& camera_;
  const GroundPoint& point_;
  cv::Point2d seen_;
};

class Prior final : public ceres::SizedCostFunction<2, 2> {
 public:
  explicit Prior(double deviation) : weight_(1 / deviation) {}
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    for (int k = 0; k < 2; ++k) residuals[k] = weight_ * parameters[0][k];
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      std::ranges::copy(std::array{weight_, 0.0, 0.0, weight_}, jacobians[0]);
    }
    return true;
  }

 private:
  double weight_;
};

/// Where the sights of the first and the last observation meet.
std::optional<GeoPoint> start_of(const std::vector<RpcCamera>& cameras, const Track& track) {
  const auto a = cameras[track.front().image].ray(track.front().pixel);
  const auto b = cameras[track.back().image].ray(track.back().pixel);
  if (!a || !b) return std::nullopt;
  const cv::Vec3d point = meet(*a, *b).point;
  if (!std::isfinite(point[0])) return std::nullopt;
  return to_geodetic(point);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// All unknowns, and what was observed of them.
class Bundle {
 public:
  Bundle(const std::vector<RpcCamera>& cameras, const std::vector<Track>& tracks)
      : cameras_(cameras), biases_(cameras.size()) {
    for (const Track& track : tracks) {
      const auto start = start_of(cameras, track);
      if (!start) continue;
      points_.emplace_back(*start);
      tracks_.push_back(&track);
    }
    moves_.resize(points_.size());
  }

  std::size_t size() const { return points_.size(); }
  double bias(std::size_t image, std::size_t axis) const { return biases_[image][axis]; }

  template <class Loss>
  void solve(const AdjustmentSettings& settings) {
    ceres::Problem problem;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      for (const Observation& o : *tracks_[i]) {
        problem.AddResidualBlock(new Reprojection(cameras_[o.image], points_[i], o.pixel),
                                 new Loss(settings.loss), biases_[o.image].data(),
                                 moves_[i].data());
      }
    }
    for (auto& bias : biases_) {
      problem.AddResidualBlock(new Prior(settings.prior), nullptr, bias.data());
    }
    if (settings.keep_first) problem.SetParameterBlockConstant(biases_.front().data());
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = 100;
    options.function_tolerance = 1e-10;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (!summary.IsSolutionUsable()) {
      throw Error("the adjustment of the cameras failed: " + summary.message);
    }
  }

  double median_residual() const {
    std::vector<double> distances;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const GeoPoint point = points_[i].at(moves_[i].data());
      for (const Observation& o : *tracks_[i]) {
        const cv::Point2d bias(biases_[o.image][0], biases_[o.image][1]);
        distances.push_back(cv::norm(cameras_[o.image].project(point) + bias - o.pixel));
      }
    }
    return median(std::move(distances));
  }

  /// Of what the points moved by since `before`.
  cv::Vec3d median_move(const std::vector<std::array<double, 3>>& before) const {
    cv::Vec3d result;
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<double> values;
      for (std::size_t i = 0; i < moves_.size(); ++i) {
        values.push_back(moves_[i][k] - before[i][k]);
      }
      result[static_cast<int>(k)] = median(std::move(values));
    }
    return result;
  }
  const std::vector<std::array<double, 3>>& moves() const { return moves_; }

 private:
  const std::vector<RpcCamera>& cameras_;
  std::vector<const Track*> tracks_;
  std::vector<GroundPoint> points_;
  std::vector<std::array<double, 3>> moves_;
  std::vector<std::array<double, 2>> biases_;
};

}  // namespace

Adjustment adjust(const std::vector<RpcCamera>& cameras, const std::vector<Track>& tracks,
                  const AdjustmentSettings& settings) {
  Bundle bundle(cameras, tracks);
  Adjustment result;
  result.tracks = bundle.size();
  result.biases.resize(cameras.size());
  if (bundle.size() == 0) return result;
  const auto before = bundle.moves();
  result.median_before = bundle.median_residual();
  // A convex loss first, from which the other one cannot go astray.
  bundle.solve<ceres::HuberLoss>(settings);
  bundle.solve<ceres::CauchyLoss>(settings);
  result.median_after = bundle.median_residual();
  result.datum = bundle.median_move(before);
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    result.biases[i] = {bundle.bias(i, 0), bundle.bias(i, 1)};
  }
  return result;
}

}  // namespace xgm::geo
