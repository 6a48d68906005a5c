// SPDX-License-Identifier: Apache-2.0
// A map of the plane that is given at the nodes of a regular grid, and its inverse.
#pragma once

#include <opencv2/core.hpp>

namespace xgm::geo {

/// Bilinear between nodes, and beyond them as the outermost cells go on.
class NodeMap {
 public:
  NodeMap() = default;
  /// `nodes(j, i)` is what place first + (i * step.width, j * step.height) is mapped to. At least
  /// 2 x 2.
  NodeMap(cv::Mat2d nodes, cv::Point2d first, cv::Size2d step);

  cv::Point2d operator()(cv::Point2d place) const;
  /// To 1e-9 px where the map is one to one.
  cv::Point2d inverse(cv::Point2d value) const;
  void move(cv::Point2d by) { first_ += by; }

 private:
  /// Value and derivatives, columns by x and y of the grid, in units of a step.
  struct Local {
    cv::Vec2d value;
    cv::Matx22d derivatives;
  };
  Local at(cv::Point2d grid) const;

  cv::Mat2d nodes_;
  cv::Point2d first_;
  cv::Size2d step_;
};

}  // namespace xgm::geo
