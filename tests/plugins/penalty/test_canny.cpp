// SPDX-License-Identifier: Apache-2.0
// P2 on edges and elsewhere: the paper, section 4.1.
#include <opencv2/imgproc.hpp>

#include "plugins/penalty/penalty_cases.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

/// Whether one of the 3x3 pixels around (x, y) is masked.
bool near_masked(const Image& image, int y, int x) {
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.size().height - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.size().width - 1); ++u) {
      if (!image.is_valid(v, u)) return true;
    }
  }
  return false;
}

PenaltyOracle canny_oracle(PenaltyPair on_edge, PenaltyPair elsewhere, double low, double high) {
  return [=](const ImagePair& pair, Direction, int y, int x, int) {
    const cv::Mat1f levels = pair.base.grey();
    cv::Mat1b grey(levels.size()), edges;
    for (int v = 0; v < grey.rows; ++v) {
      for (int u = 0; u < grey.cols; ++u) {
        grey(v, u) = pair.base.is_valid(v, u) ? cv::saturate_cast<std::uint8_t>(levels(v, u)) : 0;
      }
    }
    cv::Canny(grey, edges, low, high);
    return edges(y, x) != 0 && !near_masked(pair.base, y, x) ? on_edge : elsewhere;
  };
}

std::vector<int> p2_of_row(const Image& base, int y) {
  const auto field = stage<Penalty>("canny")->run({base, base}, Context{});
  std::vector<std::uint8_t> classes(static_cast<std::size_t>(base.size().width)), match(classes);
  field->classify({1, 0}, y, classes, match);
  std::vector<int> p2;
  for (const std::uint8_t c : classes) p2.push_back(field->table({1, 0}).at(c, 0).p2);
  return p2;
}

}  // namespace

TEST_CASE("canny lowers P2 where cv::Canny finds an edge at the base pixel") {
  check_penalties("canny", canny_oracle({24, 27}, {24, 96}, 50, 150));
  check_penalties("{type: canny, p1: 1, p2_edge: 1, p2: 200, low: 20, high: 60}",
                  canny_oracle({1, 1}, {1, 200}, 20, 60));
}

TEST_CASE("canny marks one column of a vertical step and nothing else") {
  Image image(cv::Mat1f(20, 20, 50.0F));
  image.planes[0].colRange(10, 20) = 200.0F;
  const std::vector<int> p2 = p2_of_row(image, 10);
  CHECK(std::count(p2.begin(), p2.end(), 27) == 1);
  CHECK(std::count(p2.begin(), p2.end(), 96) == 19);
  CHECK((p2[9] == 27 || p2[10] == 27));
}

TEST_CASE("canny does not take the border of a masked region for an edge") {
  Image image(cv::Mat1f(20, 20, 200.0F));
  image.valid = cv::Mat1b(20, 20, std::uint8_t{255});
  image.valid.colRange(10, 20) = std::uint8_t{0};
  for (const int p2 : p2_of_row(image, 10)) CHECK(p2 == 96);
}

TEST_CASE("canny refuses penalties and thresholds out of order") {
  CHECK_THROWS_AS(stage<Penalty>("{type: canny, p2_edge: 23}"), Error);
  CHECK_THROWS_AS(stage<Penalty>("{type: canny, p2_edge: 97}"), Error);
  CHECK_THROWS_AS(stage<Penalty>("{type: canny, low: 60, high: 50}"), Error);
}
