// SPDX-License-Identifier: Apache-2.0
// pipeline run --resume and --cache with satellite images, as a user meets them.
#include <doctest/doctest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/small_disk.hpp"
#include "geo/satellite_desk.hpp"
#include "support/support.hpp"
#include "xgm/base/random.hpp"
#include "xgm/geo/camera/write_rpc.hpp"
#include "xgm/geo/ground/dem.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using xgm::testing::check_usage_error;
using xgm::testing::contains;
using xgm::testing::Outcome;
namespace fs = std::filesystem;

namespace {

const std::string kRun = "dsm_tsgm8 scene/scene.yaml --set tile=100 ";  // four windows

struct Desk : testing::SatelliteDesk {
  Outcome run(const std::string& arguments, const std::string& before = {}) const {
    return call("run " + arguments, before);
  }
  Outcome must_run(const std::string& arguments) const {
    Outcome outcome = run(arguments);
    INFO(outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    return outcome;
  }
  /// All that a run has written but its record, which holds times.
  std::map<std::string, std::string> outputs(const std::string& folder) const {
    std::map<std::string, std::string> bytes;
    for (const auto& entry : fs::directory_iterator(*this / folder)) {
      const std::string name = entry.path().filename().string();
      if (name != "run.json") bytes[name] = read_file(entry.path().string());
    }
    return bytes;
  }
  nlohmann::json record(const std::string& folder) const {
    return nlohmann::json::parse(read_file(*this / (folder + "/run.json")));
  }
  std::size_t reused(const std::string& folder) const {
    const nlohmann::json json = record(folder);
    return json.contains("reused") ? json["reused"]["results"].size() : 0;
  }
  std::size_t stages(const std::string& folder, const std::string& kind) const {
    const nlohmann::json json = record(folder);
    std::size_t count = 0;
    for (const auto& stage : json["stages"]) {
      if (stage["kind"] == kind) ++count;
    }
    return count;
  }
  std::vector<fs::path> kept(const std::string& folder, const std::string& ending) const {
    std::vector<fs::path> files;
    if (!fs::exists(*this / folder)) return files;
    for (const auto& entry : fs::directory_iterator(*this / folder)) {
      const bool is_result = entry.path().filename() != "question.json";
      if (is_result && entry.path().extension() == ending) files.push_back(entry.path());
    }
    return files;
  }
  std::vector<fs::path> unfinished(const std::string& ending) const {
    return kept("out/unfinished.xgm", ending);
  }
  /// Ended by the signal so long after so many windows are kept, unless it ends before.
  Outcome end_halfway(const std::string& arguments, int signal = SIGKILL, std::size_t windows = 1,
                      std::chrono::milliseconds later = {}) const {
    fs::remove(*this / "pid");
    const std::jthread end([&](const std::stop_token& ended) {
      while (!fs::exists(*this / "pid") || unfinished(".json").size() < windows) {
        if (ended.stop_requested()) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      std::this_thread::sleep_for(later);
      if (!ended.stop_requested()) ::kill(std::stoi(read_file(*this / "pid")), signal);
    });
    return run(arguments + " -o out --resume", "sh -c 'echo $$ > p; mv p pid; exec \"$@\"' sh ");
  }
};

void damage(const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    std::string bytes = read_file(file.string());
    bytes[bytes.size() / 2] ^= 1;
    write_file(file.string(), bytes);
  }
}

}  // namespace

TEST_CASE("a surface run that is ended at any moment goes on and gives the bytes of one run") {
  const Desk desk;
  for (const std::string prior : {"", "--set range_prior=coarse_surface "}) {
    CAPTURE(prior);
    const std::string how = kRun + prior;
    desk.must_run(how + "-o once");
    const auto surface = desk.outputs("once");
    REQUIRE(surface.contains("dsm.tif"));
    Random random(7);
    for (std::size_t windows = 0; windows <= 4; ++windows) {
      CAPTURE(windows);
      const auto end = [&] {
        const std::chrono::milliseconds later(static_cast<int>(random.real(0, 400)));
        return desk.end_halfway(how, SIGKILL, windows, later).exit_code != 0;
      };
      // What goes on is ended, too.
      const bool is_left = end() && (windows % 2 == 0 || end());
      desk.must_run(how + "-o out --resume");
      if (is_left) CHECK(desk.reused("out") >= windows);
      CHECK(desk.outputs("out") == surface);
      fs::remove_all(desk / "out");
    }
    fs::remove_all(desk / "once");
  }
}

TEST_CASE("a surface run of another question is refused with what differs, or begun anew") {
  const Desk desk;
  desk.end_halfway(kRun);
  REQUIRE_FALSE(desk.unfinished(".json").empty());
  const auto refused = [&](const std::string& how, const std::string& what) {
    CAPTURE(how);
    const Outcome outcome = desk.run(how + " -o out --resume");
    check_usage_error(outcome, "out/unfinished.xgm was another one: ");
    CHECK(contains(outcome.errors, what));
    CHECK_FALSE(desk.unfinished(".json").empty());  // a refusal takes nothing away
  };
  refused("dsm_tsgm8 scene/scene.yaml --set tile=101", ": pipeline.tile differ");
  refused(kRun + "--set matching.matcher.scale=4", ": pipeline.matching.matcher.scale differ");
  refused(kRun + "--set fusion=k_medians", "pipeline.fusion.type");
  refused(kRun + "--area 0,0:100x100", ": --area differ");
  refused(kRun + "--geoid egm96", ": --geoid differ");
  refused(kRun + "--dem scene/dsm.tif", "DEM 1");
  refused(kRun + "--dem scene/dem.tif,egm96", ": datums of the DEM differ");
  refused(kRun + "--masks scene/image_1.tif scene/image_2.tif", ": mask 1, mask 2 differ");
  geo::RpcModel moved = desk.scene.views[1].delivered;
  moved.row.offset += 1;
  desk.write("same_RPC.TXT", geo::rpc_text(desk.scene.views[0].delivered));
  desk.write("moved_RPC.TXT", geo::rpc_text(moved));
  refused(kRun + "--cameras same_RPC.TXT moved_RPC.TXT", "RPC of image 2, camera 1, camera 2");
  const std::string image = read_file(desk / "scene/image_2.tif");
  std::string other = image;
  other[other.size() / 2] ^= 1;
  desk.write("scene/image_2.tif", other);
  refused(kRun, ": image 2 differ");
  desk.write("scene/image_2.tif", image);
  desk.must_run(kRun + "-o out --resume --threads 1");
  CHECK(desk.reused("out") > 0);
  const auto surface = desk.outputs("out");
  desk.end_halfway(kRun);
  desk.must_run(kRun + "-o out");  // anew
  CHECK(desk.reused("out") == 0);
  CHECK(desk.outputs("out") == surface);
}

TEST_CASE("a surface run makes anew what is damaged of what it kept, with a note") {
  const Desk desk;
  desk.must_run(kRun + "-o once");
  desk.end_halfway(kRun);
  const std::vector<fs::path> maps = desk.unfinished(".pfm");
  REQUIRE_FALSE(maps.empty());
  damage(maps);
  const Outcome outcome = desk.must_run(kRun + "-o out --resume");
  CHECK(contains(outcome.errors, "is damaged, and is made again"));
  CHECK(contains(desk.record("out")["warnings"].dump(), "is damaged, and is made again"));
  CHECK(desk.outputs("out") == desk.outputs("once"));
}

TEST_CASE("a surface run that is interrupted says how to go on, and what it has reused") {
  const Desk desk;
  const Outcome ended = desk.end_halfway(kRun, SIGINT);
  CHECK(ended.exit_code == 130);
  CHECK(contains(ended.errors, "interrupted; the same command with --resume goes on from "));
  CHECK(contains(desk.must_run(kRun + "-o out --resume").output, "reused:  "));
}

TEST_CASE("a surface run that fills the disk is one error, and goes on when there is room") {
  const Desk desk;
  desk.must_run(kRun + "-o once");
  const bool tried = testing::goes_on_after_full_disk(
      desk.path(), "400k",
      [&](const std::string& before) { return desk.run(kRun + "-o out --resume", before); });
  if (!tried) return;
  CHECK(desk.outputs("saved") == desk.outputs("once"));
  CHECK(desk.reused("saved") > 0);
}

TEST_CASE("with a cache, a surface run with other stages after matching matches nothing") {
  const Desk desk;
  const std::string cached = " --cache cache -o ";
  desk.must_run(kRun + "-o once");
  desk.must_run(kRun + cached + "first");
  CHECK(desk.reused("first") == 0);
  CHECK(desk.stages("first", "matcher") > 0);
  CHECK(desk.outputs("first") == desk.outputs("once"));
  for (const std::string change :
       {"fusion=k_medians", "resolution=1", "'filters=[{type: median, window: 5}]'",
        "'matching.postprocess=[{type: median}]'"}) {
    CAPTURE(change);
    desk.must_run(kRun + "--set " + change + " -o other");
    desk.must_run(kRun + "--set " + change + cached + "changed");
    CHECK(desk.reused("changed") == 4);
    CHECK(desk.stages("changed", "matcher") == 0);
    CHECK(desk.outputs("changed") == desk.outputs("other"));
  }
  desk.must_run(kRun + "--set matching.matcher.scale=4" + cached + "matched");
  CHECK(desk.reused("matched") == 0);
  desk.must_run(kRun + "--set 'range_prior={type: dem_sculpting, margin: 40}'" + cached + "bounds");
  CHECK(desk.reused("bounds") == 0);  // other disparities are searched
  CHECK_FALSE(fs::exists(desk / "first/unfinished.xgm"));
}

TEST_CASE("with a cache whose entries are damaged, a surface run makes them anew, with a note") {
  const Desk desk;
  desk.must_run(kRun + "--cache cache -o first");
  damage(desk.kept("cache", ".pfm"));
  const Outcome outcome = desk.must_run(kRun + "--cache cache -o again");
  CHECK(contains(outcome.errors, "is damaged, and is made again"));
  CHECK(desk.reused("again") == 0);
  CHECK(desk.outputs("again") == desk.outputs("first"));
  desk.must_run(kRun + "--cache cache -o last");
  CHECK(desk.reused("last") == 4);
}

TEST_CASE("the files of a raster are it and those that it is made of, but not notes of viewers") {
  const testing::SatelliteDesk desk;
  const std::string all = desk.write(
      "all.vrt",
      "<VRTDataset rasterXSize=\"128\" rasterYSize=\"128\"><VRTRasterBand dataType=\"Float32\" "
      "band=\"1\"><SimpleSource><SourceFilename relativeToVRT=\"1\">scene/image_1.tif"
      "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>");
  desk.write("all.vrt.aux.xml", "<PAMDataset/>");
  const std::vector<std::string> files = geo::files_of_raster(all);
  CHECK(files == std::vector{all, desk / "scene/image_1.tif"});
  CHECK(geo::dem_datum("nowhere.tif,egm96") == "egm96");
  CHECK(geo::dem_datum(all).empty());
}

TEST_CASE("--resume and --cache of surfaces of clouds are mistakes") {
  const Desk desk;
  desk.write("cloud.ply", "ply");
  for (const std::string option : {"--resume", "--cache cache"}) {
    check_usage_error(desk.run("dsm_tsgm8 --clouds cloud.ply -o out " + option),
                      "clouds are made a surface of without matching");
  }
}
