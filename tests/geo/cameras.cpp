// SPDX-License-Identifier: Apache-2.0
#include "geo/cameras.hpp"

namespace xgm::testing {
namespace {

using namespace xgm::geo;

/// Pixels of about 0.5 m; `lean` in pixels per metre of height, to the right and down.
RpcModel curved_model(cv::Point2d lean, double bend) {
  RpcModel model{.column = {5000, 5000},
                 .row = {5000, 5000},
                 .longitude = {55.7, 0.0241},
                 .latitude = {-21.2, 0.0226},
                 .height = {1200, 1200},
                 .column_ratio = {},
                 .row_ratio = {}};
  model.column_ratio.denominator[0] = model.row_ratio.denominator[0] = 1;
  model.column_ratio.denominator[3] = model.row_ratio.denominator[3] = -2e-3;
  model.column_ratio.numerator[1] = 1;
  model.column_ratio.numerator[2] = 0.1;
  model.column_ratio.numerator[3] = lean.x * 1200 / 5000;
  model.column_ratio.numerator[7] = bend;
  model.column_ratio.numerator[8] = -2 * bend;
  model.row_ratio.numerator[1] = 0.1;
  model.row_ratio.numerator[2] = -1;
  model.row_ratio.numerator[3] = lean.y * 1200 / 5000;
  model.row_ratio.numerator[7] = -bend;
  model.row_ratio.numerator[8] = 2 * bend;
  model.row_ratio.numerator[5] = bend;  // rows of a pushbroom lean unlike
  return model;
}

}  // namespace

geo::SatelliteImage image_with(const std::string& name, const RpcCamera& camera, cv::Size size) {
  return {.name = name,
          .file = name,
          .band = 1,
          .mask = {},
          .size = size,
          .camera = camera,
          .acquisition = {}};
}

std::pair<SatelliteImage, SatelliteImage> curved_pair() {
  const cv::Size size(10000, 10000);
  return {image_with("curved", RpcCamera(curved_model({0.1, 0.2}, 3e-4)), size),
          image_with("curved", RpcCamera(curved_model({-0.2, -0.25}, -5e-4)), size)};
}

}  // namespace xgm::testing
