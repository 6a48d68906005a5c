// SPDX-License-Identifier: Apache-2.0
// Key points of a pair should lie on each other's epipolar lines. What they lie beside them, in the
// median, is the pointing error of the pair across the lines, and is shared by the two cameras. An
// error along the lines cannot be told from height. De Franchis, Meinhardt-Llopis, Michel, Morel,
// Facciolo: An automatic and modular stereo pipeline for pushbroom images (ISPRS Annals 2014),
// Section 4.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "plugins/pointing/tie_points/search.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

/// How far a pair is off, and how corrections of its cameras change that.
struct Equation {
  PairChoice pair;
  cv::Vec2d base, match;  ///< what moving the image by a pixel adds
  double offset = 0;      ///< px
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class Keypoints final : public Pointing {
 public:
  struct Parameters {
    TieSearch search;
    int min_matches = 10;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    geo::describe(p.search, set);
    set.add("min_matches", p.min_matches,
            "With fewer matches the cameras of a pair are left as they are, with a warning.")
        .range(3, 100000);
  }

  explicit Keypoints(Parameters parameters) : p_(parameters) {}

  std::vector<SatelliteImage> run(const std::vector<SatelliteImage>& images,
                                  const std::vector<PairChoice>& pairs,
                                  const GroundKnowledge& ground,
                                  const Context& context) const override {
    std::vector<Equation> equations;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const SatelliteImage& base = images[pairs[i].base];
      const SatelliteImage& match = images[pairs[i].match];
      const std::vector<KeypointMatch> matches = find_ties(base, match, ground.heights, p_.search);
      const std::string what = base.name + " " + match.name;
      context.figure(what + " matches", static_cast<double>(matches.size()));
      if (matches.size() < static_cast<std::size_t>(p_.min_matches)) {
        context.warn(what + ": only " + std::to_string(matches.size()) +
                     " key points match; their cameras are used as they are");
        continue;
      }
      equations.push_back(equation(pairs[i], base, match, matches, ground.heights));
      context.figure(what + " across_px", equations.back().offset);
      context.progress(static_cast<double>(i + 1) / static_cast<double>(pairs.size()));
    }
    return corrected(images, equations);
  }

 private:
  static Equation equation(const PairChoice& pair, const SatelliteImage& base,
                           const SatelliteImage& match, const std::vector<KeypointMatch>& matches,
                           const HeightInterval& heights) {
    std::vector<double> across;
    cv::Vec2d normal;
    for (const KeypointMatch& m : matches) {
      across.push_back(m.across);
      normal += m.normal;
    }
    normal /= cv::norm(normal);
    // What moving the base pixel does to its line.
    const cv::Point2d here = matches[matches.size() / 2].base;
    const double height = (heights.min + heights.max) / 2;
    const auto seen = [&](cv::Point2d pixel) {
      const auto point = base.camera.localize(pixel, height);
      return point ? match.camera.project(*point) : cv::Point2d();
    };
    const cv::Point2d x = seen(here + cv::Point2d(1, 0)) - seen(here);
    const cv::Point2d y = seen(here + cv::Point2d(0, 1)) - seen(here);
    return {pair, cv::Vec2d(-normal.dot({x.x, x.y}), -normal.dot({y.x, y.y})), normal,
            median(std::move(across))};
  }

  /// The smallest moves of all images that take the offsets of all pairs out, least squares.
  static std::vector<SatelliteImage> corrected(std::vector<SatelliteImage> images,
                                               const std::vector<Equation>& equations) {
    if (equations.empty()) return images;
    const auto n = static_cast<Eigen::Index>(equations.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, 2 * static_cast<Eigen::Index>(images.size()));
    Eigen::VectorXd b(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Equation& e = equations[static_cast<std::size_t>(i)];
      const auto base = 2 * static_cast<Eigen::Index>(e.pair.base);
      const auto match = 2 * static_cast<Eigen::Index>(e.pair.match);
      for (int k = 0; k < 2; ++k) {
        a(i, base + k) = e.base[k];
        a(i, match + k) = e.match[k];
      }
      b(i) = e.offset;
    }
    const Eigen::VectorXd moves = a.completeOrthogonalDecomposition().solve(b);
    for (std::size_t i = 0; i < images.size(); ++i) {
      const auto k = 2 * static_cast<Eigen::Index>(i);
      // Points are seen where key points are: the projection moves by `moves`.
      images[i].camera = images[i].camera.cropped({-moves(k), -moves(k + 1)});
    }
    return images;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Keypoints>("keypoints",
                          "Corrects each pair across its epipolar lines, by key points.",
                          "De Franchis, Meinhardt-Llopis, Michel, Morel, Facciolo: An automatic "
                          "and modular stereo pipeline for pushbroom images, ISPRS Annals 2014");
}
