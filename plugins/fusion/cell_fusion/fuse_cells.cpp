// SPDX-License-Identifier: Apache-2.0
#include "plugins/fusion/cell_fusion/fuse_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "xgm/base/parallel.hpp"

namespace xgm::geo {

float median(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 != 0) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

FusedSurface fuse(const std::vector<Raster>& surfaces, const std::vector<double>& offsets,
                  int min_pairs, const HeightRule& rule) {
  const cv::Size size = surfaces.front().values.size();
  FusedSurface fused{surfaces.front(), cv::Mat1f(size, 0.0F), cv::Mat1f(size, kNone), {}};
  fused.heights.values = cv::Mat1f(size, kNone);
  parallel_for(0, size.height, [&](int y) {
    std::vector<float> heights;
    for (int x = 0; x < size.width; ++x) {
      heights.clear();
      for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const float height = surfaces[i].values(y, x);
        if (!std::isnan(height)) heights.push_back(height - static_cast<float>(offsets[i]));
      }
      fused.count(y, x) = static_cast<float>(heights.size());
      if (heights.empty() || heights.size() < static_cast<std::size_t>(min_pairs)) continue;
      const float height = rule(heights);
      fused.heights.values(y, x) = height;
      if (heights.size() < 2) continue;
      for (float& h : heights) h = std::abs(h - height);
      fused.spread(y, x) = median(heights);
    }
  });
  return fused;
}

/// Median of what each surface lies above the fused one, m; 0 if they share no cell.
std::vector<double> offsets_from(const std::vector<Raster>& surfaces, const cv::Mat1f& fused) {
  std::vector<double> offsets;
  for (const Raster& surface : surfaces) {
    std::vector<float> differences;
    for (int y = 0; y < fused.rows; ++y) {
      for (int x = 0; x < fused.cols; ++x) {
        const float difference = surface.values(y, x) - fused(y, x);
        if (!std::isnan(difference)) differences.push_back(difference);
      }
    }
    offsets.push_back(differences.empty() ? 0 : double{median(differences)});
  }
  return offsets;
}

}  // namespace

void describe(CellFusion& fusion, ParameterSet& set) {
  set.add("align", fusion.align,
          "Take out of each surface the median of what it lies above the fused one, then fuse "
          "again. Offsets are found and recorded in any case.");
  set.add("min_pairs", fusion.min_pairs, "Cells that fewer pairs have seen are left empty.")
      .range(1, 1000);
}

FusedSurface fuse_cells(const std::vector<Raster>& surfaces, const CellFusion& fusion,
                        const HeightRule& rule, const Context& context) {
  std::vector<double> offsets(surfaces.size(), 0);
  FusedSurface fused = fuse(surfaces, offsets, fusion.min_pairs, rule);
  std::vector<double> found = offsets_from(surfaces, fused.heights.values);
  for (std::size_t i = 0; i < found.size(); ++i) {
    context.figure("offset_" + std::to_string(i + 1) + "_m", found[i]);
  }
  if (fusion.align) fused = fuse(surfaces, found, fusion.min_pairs, rule);
  fused.offsets = std::move(found);
  return fused;
}

}  // namespace xgm::geo
