// SPDX-License-Identifier: Apache-2.0
// A real pair end to end, beside the surface of an independent program.
#include <algorithm>
#include <cmath>

#include "geo/photo_check.hpp"
#include "support/support.hpp"
#include "xgm/geo/registry.hpp"
#include "xgm/geo/stage/surface_family.hpp"
#include "xgm/pipeline/lookup.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::test_data;

TEST_CASE("the shipped satellite pipelines are sound, and describe themselves") {
  Registry registry = Registry::with_builtins();
  add_geo(registry);
  for (const char* name : {"dsm_tsgm8", "dsm_tmgm16.yaml", "dsm_tmgm16_refined"}) {
    CAPTURE(name);
    const Pipeline pipeline = require_pipeline(name, registry);
    CHECK(dynamic_cast<const SurfaceFamily*>(&pipeline.family()) != nullptr);
    CHECK(pipeline.resolved_json().find("census") != std::string::npos);
  }
  // The part that is named can be changed like any other.
  const Pipeline changed =
      require_pipeline("dsm_tsgm8", registry, {{"matching.matcher.scale", "4"}});
  CHECK(changed.graph().find("scale=4") != std::string::npos);
  const LoadedPipeline misnamed =
      load_pipeline_text("xgm: 1\ntype: surface\nmatching: tmgm61.yaml\n", "mine.yaml", registry);
  REQUIRE_FALSE(misnamed.pipeline);
  CHECK(to_string(misnamed.diagnostics).find("mine.yaml:3:11") != std::string::npos);
  CHECK(to_string(misnamed.diagnostics).find("tmgm16.yaml") != std::string::npos);
}

TEST_CASE("a file whose keys are those of surfaces is told that it lacks its type, and no more") {
  Registry registry = Registry::with_builtins();
  add_geo(registry);
  const auto messages = [&](const std::string& text, const std::vector<Override>& changes = {}) {
    const LoadedPipeline loaded = load_pipeline_text(text, "mine.yaml", registry, changes);
    return loaded.pipeline ? "" : to_string(loaded.diagnostics);
  };
  const std::string lacks =
      " is for pipelines of type surface, and this file names no type; add 'type: surface' at its "
      "top";
  const std::string surface = "xgm: 1\npairs: all\npointing: none\nmatching: tsgm8.yaml\n";
  CHECK(messages(surface) == "mine.yaml:2:1: error: 'pairs'" + lacks);
  CHECK(messages("matching: tsgm8\n") == "mine.yaml:1:1: error: 'matching'" + lacks);
  CHECK(messages(surface + "fusio: median\n") ==
        "mine.yaml:2:1: error: 'pairs'" + lacks +
            "\nmine.yaml:5:1: error: a pipeline has no parameter 'fusio'; did you mean 'fusion'?");
  CHECK(messages(surface, {{"type", "surface"}, {"matching.matcher.scale", "4"}}).empty());
  CHECK(messages("type: surface\n" + surface).empty());
  // Files of pairs with a key of surfaces are files of pairs.
  const std::string mixed = messages("matcher: opencv_sgbm\npointing: none\n");
  CHECK(mixed.find("2:1: error: a pipeline has no parameter 'pointing'") != std::string::npos);
  CHECK(mixed.find("type surface") == std::string::npos);
}

TEST_CASE("Réunion without a DEM: the surface agrees with that of another program") {
  const auto data = test_data("a Pleiades pair and its surface");
  if (!data) return;
  const std::string s2p = (*data / "satellite/s2p/tests/data/").string();
  Registry registry = Registry::with_builtins();
  add_geo(registry);
  const Pipeline pipeline = require_pipeline("dsm_tmgm16_refined", registry);
  const auto& family = dynamic_cast<const SurfaceFamily&>(pipeline.family());
  SurfaceRequest request;
  request.images = {open_image(s2p + "input_pair/img_01.tif"),
                    open_image(s2p + "input_pair/img_02.tif")};
  const SurfaceResult result = family.run(request, Context());
  const Raster& dsm = result.fused.heights;
  const Raster peer = read_raster(s2p + "expected_output/pair/dsm.tif");
  std::vector<double> differences;
  int peer_cells = 0;
  for (int y = 0; y < peer.values.rows; ++y) {
    for (int x = 0; x < peer.values.cols; ++x) {
      if (std::isnan(peer.values(y, x))) continue;
      ++peer_cells;
      const cv::Point2d cell = dsm.place.cell(peer.place.centre(x, y));
      const cv::Point c(cvRound(cell.x), cvRound(cell.y));
      if (!cv::Rect({}, dsm.values.size()).contains(c) || std::isnan(dsm.values(c))) continue;
      differences.push_back(double{dsm.values(c)} - double{peer.values(y, x)});
    }
  }
  REQUIRE_FALSE(differences.empty());
  const auto median = [](std::vector<double> v) {
    std::sort(v.begin(), v.end());
    return v[v.size() / 2];
  };
  const double middle = median(differences);
  std::vector<double> deviations;
  for (const double d : differences) deviations.push_back(std::abs(d - middle));
  const double mad = median(deviations);
  const auto within = static_cast<double>(std::ranges::count_if(
                          differences, [](double d) { return std::abs(d) < 1; })) /
                      static_cast<double>(differences.size());
  const double coverage = static_cast<double>(differences.size()) / peer_cells;
  MESSAGE("median " << middle << " m, MAD " << mad << " m, within 1 m " << within << ", coverage "
                    << coverage);
  const auto photo = xgm::testing::photo_check(dsm, result.images[0], result.images[1]);
  MESSAGE("both images through the surface: " << photo.along << " px along, " << photo.across
                                              << " px across, " << photo.patches << " patches");
  const auto before = xgm::testing::photo_check(dsm, request.images[0], request.images[1]);
  MESSAGE("with the vendor's cameras: " << before.along << " px along, " << before.across
                                        << " px across");
  CHECK(photo.patches > 300);
  CHECK(std::abs(photo.along) <= 0.1);
  CHECK(std::abs(photo.across) <= 0.1);
  CHECK(std::abs(std::abs(before.across - photo.across) - 0.77) <= 0.1);
  CHECK(std::abs(middle) <= 0.3);
  CHECK(mad <= 0.4);
  CHECK(within >= 0.8);
  CHECK(coverage >= 0.85);
}
