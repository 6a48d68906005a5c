// SPDX-License-Identifier: Apache-2.0
// All cameras at once, on generated tie points of known errors and on a real pair.
#include <cmath>
#include <random>

#include "geo/cameras.hpp"
#include "geo/recorder.hpp"
#include "plugins/pointing/bundle_adjustment/adjust.hpp"
#include "support/support.hpp"
#include "xgm/geo/stage/pointing.hpp"

#ifdef XGM_HAS_CERES

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::geo_stage;
using xgm::testing::Recorder;
using xgm::testing::test_data;

namespace {

/// Four cameras, of which the vendor says something else than is true.
struct Block {
  std::vector<RpcCamera> truth, vendor;
  std::vector<cv::Point2d> biases{{4, -3}, {-2, 5}, {1.5, 2.5}, {-3, -6}};
  std::vector<Track> tracks;
};

Block block(double noise, double wrong) {
  Block b;
  const auto [one, two] = xgm::testing::curved_pair();
  RpcModel third = one.camera.model(), fourth = two.camera.model();
  third.row_ratio.numerator[3] = -0.03;
  fourth.column_ratio.numerator[3] = 0.05;
  b.truth = {one.camera, two.camera, RpcCamera(third), RpcCamera(fourth)};
  for (std::size_t i = 0; i < 4; ++i) b.vendor.push_back(b.truth[i].cropped(b.biases[i]));
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::normal_distribution<double> bell(0, noise);
  for (int k = 0; k < 400; ++k) {
    const GeoPoint point{55.7 + 0.02 * unit(random), -21.2 + 0.02 * unit(random),
                         1200 + 300 * unit(random)};
    Track track;
    for (std::size_t i = 0; i < 4; ++i) {
      if (static_cast<std::size_t>(k) % 4 == i) continue;  // no image shows all points
      cv::Point2d pixel = b.truth[i].project(point) + cv::Point2d(bell(random), bell(random));
      if (std::abs(unit(random)) < wrong) pixel += cv::Point2d(15, -20) * unit(random);
      track.push_back({i, pixel});
    }
    b.tracks.push_back(track);
  }
  return b;
}

/// What is left of the differences of found and true biases when the shift of the ground that
/// explains them best is taken out, px: no tie point can tell it.
double error_but_for_datum(const Block& b, const std::vector<cv::Point2d>& found) {
  cv::Mat1d a(8, 3), d(8, 1), shift;
  const GeoPoint here{55.7, -21.2, 1200};
  const std::array<GeoPoint, 3> moved{GeoPoint{55.7 + 1e-5, -21.2, 1200},
                                      GeoPoint{55.7, -21.2 + 1e-5, 1200},
                                      GeoPoint{55.7, -21.2, 1201}};
  for (int i = 0; i < 4; ++i) {
    const RpcCamera& camera = b.truth[static_cast<std::size_t>(i)];
    for (int k = 0; k < 3; ++k) {
      const cv::Point2d slope =
          camera.project(moved[static_cast<std::size_t>(k)]) - camera.project(here);
      a(2 * i, k) = slope.x;
      a(2 * i + 1, k) = slope.y;
    }
    const auto n = static_cast<std::size_t>(i);
    d(2 * i, 0) = found[n].x - b.biases[n].x;
    d(2 * i + 1, 0) = found[n].y - b.biases[n].y;
  }
  cv::solve(a, d, shift, cv::DECOMP_SVD);
  return cv::norm(a * shift - d, cv::NORM_INF);
}

}  // namespace

TEST_CASE("the biases of four cameras come out exactly, but for the shift of all the ground") {
  const Block b = block(0, 0);
  const Adjustment found = adjust(b.vendor, b.tracks, {.prior = 1000});
  CHECK(found.tracks == 400);
  CHECK(found.median_before > 0.5);
  CHECK(found.median_after < 1e-3);
  CHECK(error_but_for_datum(b, found.biases) < 1e-2);
  // The datum: no shift of the ground would make the biases smaller than these.
  double squares = 0, truth = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    squares += found.biases[i].dot(found.biases[i]);
    truth += b.biases[i].dot(b.biases[i]);
  }
  CHECK(squares < truth);
  CHECK(cv::norm(found.datum) > 0.1);
}

TEST_CASE("noise of 0.3 px and a tenth of wrong observations leave the biases right to 0.1 px") {
  const Block b = block(0.3, 0.1);
  const Adjustment found = adjust(b.vendor, b.tracks, {});
  const double error = error_but_for_datum(b, found.biases);
  MESSAGE("largest error " << error << " px; median residual " << found.median_before << " -> "
                           << found.median_after << " px");
  CHECK(error < 0.1);
  CHECK(found.median_after < 0.4);
  const Adjustment first = adjust(b.vendor, b.tracks, {.keep_first = true});
  CHECK(cv::norm(first.biases[0]) == 0);
  CHECK(error_but_for_datum(b, first.biases) < 0.1);
}

TEST_CASE("without tie points cameras stay as they are") {
  const Block b = block(0, 0);
  const Adjustment found = adjust(b.vendor, {}, {});
  CHECK(found.tracks == 0);
  for (const cv::Point2d& bias : found.biases) CHECK(cv::norm(bias) == 0);
}

TEST_CASE("matches of several pairs that share key points are one point, and contradictions none") {
  const auto match = [](cv::Point2d base, cv::Point2d there) {
    return KeypointMatch{base, there, 0, {}};
  };
  const std::vector<Track> tracks = join_tracks(
      {{0, 1}, {0, 2}, {1, 2}}, {{match({1, 1}, {10, 10}), match({2, 2}, {20, 20})},
                                 {match({1, 1}, {100, 100}), match({3, 3}, {300, 300})},
                                 {match({10, 10.001}, {100, 100}), match({20, 20}, {200, 200}),
                                  match({20, 20}, {201, 200})}});  // two places in image 2
  REQUIRE(tracks.size() == 2);
  REQUIRE(tracks[0].size() == 3);
  CHECK(tracks[0][2].image == 2);
  CHECK(tracks[0][2].pixel == cv::Point2d(100, 100));
  CHECK(tracks[1].size() == 2);
  CHECK(tracks[1][0].pixel == cv::Point2d(3, 3));
}

TEST_CASE("Réunion: the adjustment takes out what key points lie beside their epipolar lines") {
  const auto data = test_data("a Pleiades pair");
  if (!data) return;
  const std::string folder = (*data / "satellite/s2p/tests/data/input_pair/").string();
  const std::vector<SatelliteImage> images{open_image(folder + "img_01.tif"),
                                           open_image(folder + "img_02.tif")};
  const HeightInterval heights{2270, 2377};
  const auto across = [&](const std::vector<SatelliteImage>& pair) {
    std::vector<double> found;
    for (const KeypointMatch& m :
         match_keypoints(pair[0], pair[1], {{}, images[0].size}, heights, 5)) {
      found.push_back(m.across);
    }
    REQUIRE(found.size() > 100);
    std::sort(found.begin(), found.end());
    return found[found.size() / 2];
  };
  Recorder recorder;
  const auto adjusted =
      geo_stage<Pointing>("bundle_adjustment")
          ->run(images, {{0, 1}}, GroundKnowledge{nullptr, heights}, Context(&recorder));
  const double before = across(images), after = across(adjusted);
  MESSAGE("across " << before << " -> " << after << " px, " << recorder.figures.at("tie_points")
                    << " points, datum " << recorder.figures.at("datum_east_m") << ", "
                    << recorder.figures.at("datum_north_m") << ", "
                    << recorder.figures.at("datum_up_m") << " m");
  CHECK(std::abs(std::abs(before) - 0.77) < 0.1);
  CHECK(std::abs(after) < 0.05);
}

#endif
