// SPDX-License-Identifier: Apache-2.0
// Penalty "canny": disparity may jump cheaply at the edges of the base image (the paper, 4.1).
#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "plugins/penalty/step_penalties/describe.hpp"
#include "xgm/plugin.hpp"

namespace {

struct Parameters {
  xgm::penalty::Weights weights;
  int p2_edge = 27;
  double low = 50;
  double high = 150;
};

/// Non-zero on the edges of the grey image. Masked pixels have no grey level: whatever is found
/// within reach of the 3x3 gradient of one is not an edge of the scene.
cv::Mat1b find_edges(const xgm::Image& image, double low, double high) {
  cv::Mat1b grey, edges;
  image.grey().convertTo(grey, CV_8U);
  if (!image.valid.empty()) grey.setTo(0, image.valid == 0);
  cv::Canny(grey, edges, low, high);
  if (!image.valid.empty()) {
    cv::Mat1b near_masked;
    cv::dilate(image.valid == 0, near_masked, cv::Mat1b::ones(3, 3));
    edges.setTo(0, near_masked);
  }
  return edges;
}

class CannyField final : public xgm::PenaltyField {
 public:
  CannyField(cv::Mat1b edges, const Parameters& p) : edges_(std::move(edges)) {
    table_.base_classes = 2;
    table_.entries = {{p.weights.p1, p.weights.p2}, {p.weights.p1, p.p2_edge}};
  }

  xgm::PenaltyTable table(xgm::Direction) const override { return table_; }

  void classify(xgm::Direction, int y, std::span<std::uint8_t> base,
                std::span<std::uint8_t> match) const override {
    const std::uint8_t* const row = edges_[y];
    std::transform(row, row + edges_.cols, base.begin(),
                   [](std::uint8_t edge) { return static_cast<std::uint8_t>(edge != 0); });
    std::fill(match.begin(), match.end(), std::uint8_t{0});
  }

 private:
  cv::Mat1b edges_;
  xgm::PenaltyTable table_;
};

class Canny final : public xgm::Penalty {
 public:
  using Parameters = ::Parameters;

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    xgm::penalty::describe(p.weights, set);
    xgm::penalty::describe("p2_edge", p.p2_edge, "Penalty P2 at pixels on an edge.", set);
    set.add("low", p.low,
            "Lower threshold of the edge detector: edges go on while the 3x3 Sobel gradient (4 at "
            "a straight step of one grey level) is above it.")
        .range(0, 2040);
    set.add("high", p.high, "Upper threshold of the edge detector: edges begin above it.")
        .range(0, 2040);
    set.rule({"p2_edge", "p1"}, "must not be below p1", [&p] { return p.p2_edge >= p.weights.p1; });
    set.rule({"p2", "p2_edge"}, "must not be below p2_edge",
             [&p] { return p.weights.p2 >= p.p2_edge; });
    set.rule({"high", "low"}, "must not be below low", [&p] { return p.high >= p.low; });
  }

  explicit Canny(const Parameters& p) : parameters_(p) {}

  std::unique_ptr<const xgm::PenaltyField> run(const xgm::ImagePair& pair,
                                               const xgm::Context&) const override {
    return std::make_unique<CannyField>(find_edges(pair.base, parameters_.low, parameters_.high),
                                        parameters_);
  }

 private:
  Parameters parameters_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Canny>("canny", "P2 is lower on the Canny edges of the base image.",
                      "Patil et al., A comparative evaluation of SGM variants (including a new "
                      "variant, tMGM) for dense stereo matching, section 4.1; Canny, PAMI 1986");
}
