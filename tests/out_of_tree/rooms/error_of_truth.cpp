// SPDX-License-Identifier: Apache-2.0
// Judges the exact disparities of a generated scene by themselves: no pixel is wrong.
#include <cstdio>
#include <xgm/evaluation/metrics.hpp>
#include <xgm/testing/synthetic.hpp>

int main() {
  const auto scene = xgm::testing::make_scene({});
  xgm::DisparityMap map(scene.truth.size());
  for (int y = 0; y < map.size().height; ++y)
    for (int x = 0; x < map.size().width; ++x) map.set(y, x, scene.truth(y, x));
  const xgm::Evaluation evaluation = xgm::evaluate(map, scene.truth, {.deltas = {0.5}});
  std::printf("%lld pixels, %g wrong\n", static_cast<long long>(evaluation.judged),
              evaluation.at.front().total);
  return evaluation.judged > 0 && evaluation.at.front().total == 0 ? 0 : 1;
}
