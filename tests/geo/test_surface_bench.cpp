// SPDX-License-Identifier: Apache-2.0
// Benches of surfaces, with runs that are faked.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "geo/cameras.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/base/json.hpp"
#include "xgm/geo/bench/surface_bench.hpp"
#include "xgm/geo/evaluation/spikes.hpp"
#include "xgm/io/file.hpp"
#include "xgm/pipeline/lookup.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

constexpr float kGround = 100;

/// A region of two scenes of three images; runs take a surface that lies a metre and a half too
/// high, or is right but for one cell.
struct Desk : TemporaryFolder {
  Desk() {
    for (const std::string name : {"one", "two"}) {
      std::filesystem::create_directories(*this / ("region/" + name));
      write_raster(*this / ("region/" + name + "/dsm.tif"), raster(cv::Mat1f(20, 30, kGround)));
      for (int i = 1; i <= 3; ++i) {
        write("region/" + name + "/" + std::to_string(i) + ".tif", "image of " + name);
        cv::Mat1f visible(20, 30, 255.0F);
        if (i == 3) visible.colRange(0, 10) = 0.0F;
        write_raster(*this / ("region/" + name + "/v" + std::to_string(i) + ".tif"),
                     raster(visible));
      }
      write("region/" + name + "/scene.yaml",
            "images: [1.tif, 2.tif, 3.tif]\nvisible: [v1.tif, v2.tif, v3.tif]\ntruth: dsm.tif\n");
    }
    for (const SurfaceScene& scene : find_surface_scenes(*this / "region")) {
      for (const SurfaceScene& pair : pairs_of(scene)) request.scenes.push_back(pair);
    }
    request.output = *this / "out";
    for (const std::string name : {"high", "hole"}) {
      request.pipelines.push_back(
          {.name = name, .file = name + ".yaml", .overrides = {}, .resolved = "{}"});
    }
  }
  static Raster raster(const cv::Mat1f& values) {
    return {values, {500000, 5000000, 1, -1}, "EPSG:32632", {}};
  }

  RunOutcome fake(const BenchPipeline& pipeline, const SurfaceScene& scene,
                  const std::string& where) {
    runs.push_back(pipeline.name + " " + scene.name);
    if (scene.name == broken) return {.interrupted = false, .failure = "is broken"};
    cv::Mat1f heights(20, 30, pipeline.name == "high" ? kGround + 1.5F : kGround);
    if (pipeline.name == "hole") heights(5, 15) = NAN;
    write_raster(where + "/dsm.tif", raster(heights));
    write_file(
        where + "/run.json",
        R"({"seconds": 2, "peak_memory_bytes": 3e6, "search": {"disparities_per_pixel": 7}})");
    return {};
  }
  SurfaceBenchResult bench() {
    runs.clear();
    return run_surface_bench(request, {.run = [this](const auto&... all) { return fake(all...); }});
  }

  SurfaceBenchRequest request;
  std::vector<std::string> runs;
  std::string broken;
};

}  // namespace

TEST_CASE("every pair is judged where both of its images show the truth") {
  Desk desk;
  REQUIRE(desk.request.scenes.size() == 6);
  CHECK(desk.request.scenes[0].name == "one_1_2");
  CHECK(desk.request.scenes[0].set == "region");
  const SurfaceBenchResult result = desk.bench();
  CHECK(desk.runs.size() == 12);
  CHECK(result.failures() == 0);
  const SurfaceCell& high = result.at(0, 0);
  CHECK(high.errors.truth_cells == 600);
  CHECK(high.errors.completeness == 0);
  CHECK(high.errors.median_error == doctest::Approx(1.5));
  CHECK(high.levelled.completeness == 1);
  CHECK(high.seconds == 2);
  CHECK(high.search == 7);
  CHECK(result.at(1, 1).errors.truth_cells == 400);  // images 1 and 3
  CHECK(result.at(1, 1).errors.coverage == doctest::Approx(399. / 400));
  CHECK_FALSE(result.at(1, 1).disparities);
}

TEST_CASE("tables of surfaces average over the pairs of a region, and rank what is comparable") {
  Desk desk;
  const SurfaceBenchResult result = desk.bench();
  const Json json = Json::parse(surface_bench_json(result));
  const Json& hole = *(json.at("averages").begin() + 1);
  const double complete = (2 * 599. / 600 + 4 * 399. / 400) / 6;
  CHECK(hole.at("figures").at("completeness").number() == doctest::Approx(complete));
  CHECK(hole.at("figures").at("peak_bytes").number() == 3e6);
  CHECK(json.at("cells").size() == 12);
  const std::string csv = surface_bench_csv(result);
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 2 + 12);
  CHECK(contains(csv, "\naverage,region,,high,done,6,0,1.5,1.5,1.5,1,1,0,0,0,"));
  CHECK(contains(surface_bench_text(result), "region: average of 6 scenes"));
  CHECK(contains(surface_bench_markdown(result), "| one_1_2 | high | 0.00 |"));
  CHECK(contains(surface_bench_html(result), "high/region/one_1_2/dsm.png"));
}

TEST_CASE("a bench of surfaces goes on where it was, and tells what failed") {
  Desk desk;
  desk.broken = "two_1_3";
  CHECK(desk.bench().failures() == 2);
  const SurfaceBenchResult again = desk.bench();
  CHECK(desk.runs == std::vector<std::string>{"high two_1_3", "hole two_1_3"});
  CHECK(contains(surface_bench_text(again), "high failed on two_1_3: is broken"));
  desk.broken.clear();
  CHECK(desk.bench().failures() == 0);
  desk.write("region/one/1.tif", "another image");
  desk.bench();
  CHECK(desk.runs.size() == 4);  // of both pipelines, the pairs with this image
}

TEST_CASE("a scene file that names nothing good is refused, with the place and the remedy") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& yaml) {
    folder.write("scene.yaml", yaml);
    return error_of([&] { find_surface_scenes(folder.path()); });
  };
  folder.write("a.tif", "");
  folder.write("b.tif", "");
  CHECK(contains(refused("images: [a.tif"), "scene.yaml:"));
  CHECK(contains(refused("truth: a.tif\nimages: [a.tif]"), "'images' needs at least two files"));
  CHECK(contains(refused("images: [a.tif, b.tif]"), "'truth' is missing"));
  CHECK(contains(refused("images:\n- a.tif\n- c.tif"), "scene.yaml:3:3: "));
  CHECK(contains(refused("images: [a.tif, b.tif]\ntruth: b.tif\nvisible: [a.tif]"),
                 "one file for each"));
  const TemporaryFolder none;
  CHECK(contains(error_of([&] { find_surface_scenes(none.path()); }), "holds no satellite scene"));
}

TEST_CASE("spikes are cells of flats that are far off, as a naive count says") {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> chance(0, 1);
  cv::Mat1f truth(40, 50, 10.0F), surface(40, 50, 10.0F);
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      if (x > 30) truth(y, x) += static_cast<float>(x - 30);
      if (chance(random) < 0.01F) truth(y, x) = NAN;
      surface(y, x) = truth(y, x) + (chance(random) < 0.1F ? 8.0F : 1.0F);
      if (chance(random) < 0.1F) surface(y, x) = NAN;
    }
  }
  int cells = 0, spikes = 0;
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      bool flat = !std::isnan(surface(y, x));
      float low = INFINITY, high = -INFINITY;
      for (int v = std::max(0, y - 2); v <= std::min(truth.rows - 1, y + 2); ++v) {
        for (int u = std::max(0, x - 2); u <= std::min(truth.cols - 1, x + 2); ++u) {
          flat = flat && !std::isnan(truth(v, u));
          low = std::min(low, truth(v, u));
          high = std::max(high, truth(v, u));
        }
      }
      if (!flat || high - low > 1) continue;
      ++cells;
      spikes += std::abs(surface(y, x) - truth(y, x)) > 5 ? 1 : 0;
    }
  }
  CHECK(cells > 200);
  CHECK(spikes > 10);
  CHECK(spikes_on_flats(surface, truth, 0.5, {.reach = 1, .level = 1, .size = 5}) ==
        doctest::Approx(static_cast<double>(spikes) / cells));
}

TEST_CASE("rank correlation is that of the ranks, whatever the values") {
  CHECK(rank_correlation({1, 2, 3, 4}, {1, 10, 100, 1e6}) == doctest::Approx(1));
  CHECK(rank_correlation({1, 2, 3, 4}, {8, 6, 5, -9}) == doctest::Approx(-1));
  // Without ties: 1 - 6 sum d^2 / (n (n^2 - 1)), here d = 1, 1, 1, 1, 0.
  CHECK(rank_correlation({10, 20, 30, 40, 50}, {2, 1, 4, 3, 5}) == doctest::Approx(0.8));
  // Ties share ranks: 1.5, 1.5, 3 and 1, 2.5, 2.5.
  CHECK(rank_correlation({0, 0, 1}, {0, 7, 7}) == doctest::Approx(0.5));
  CHECK(rank_correlation({1, 2, NAN, 3}, {1, 2, 5, 3}) == doctest::Approx(1));
  CHECK(std::isnan(rank_correlation({1, 2}, {1, 2})));
  CHECK(std::isnan(rank_correlation({1, 1, 1}, {1, 2, 3})));
}

TEST_CASE("--set takes another pipeline as the matching part, and then parameters of that one") {
  Registry registry = Registry::with_builtins();
  add_geo(registry);
  const auto resolved = [&](const std::vector<Override>& overrides) {
    return Json::parse(require_pipeline("dsm_tsgm8", registry, overrides).resolved_json());
  };
  const auto matcher = [](const Json& pipeline) { return pipeline.at("matching").at("matcher"); };
  CHECK(matcher(resolved({})).at("type").text() == "pyramid");
  const Json flat =
      resolved({{"matching", "mgm16"}, {"matching.matcher.matcher.cost.window", "7"}});
  CHECK(matcher(flat).at("type").text() == "left_right");
  CHECK(matcher(flat).at("matcher").at("aggregation").at("type").text() == "mgm");
  CHECK(matcher(flat).at("matcher").at("cost").at("window").number() == 7);
}
