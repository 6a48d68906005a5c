// SPDX-License-Identifier: Apache-2.0
// pipeline run --resume and --cache, as a user meets them.
#include <doctest/doctest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/program.hpp"
#include "apps/small_disk.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/base/random.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/write_maps.hpp"
#include "xgm/testing/synthetic.hpp"

using namespace xgm;
using xgm::testing::check_usage_error;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

struct Desk : TemporaryFolder {
  explicit Desk(cv::Size size = {240, 160}, int disparities = 32) {
    fs::create_directory(*this / "scene");
    testing::SceneOptions options;
    options.size = size;
    options.disparities = {0, disparities};
    const testing::SyntheticScene scene = testing::make_scene(options);
    write_png(*this / "scene/im0.png", picture(scene.pair.base));
    write_png(*this / "scene/im1.png", picture(scene.pair.match));
    write("scene/calib.txt", "ndisp=" + std::to_string(disparities) + "\n");
  }
  Outcome run(const std::string& arguments, const std::string& before = {}) const {
    return testing::pipeline(path(), "run " + arguments, before);
  }
  void must_run(const std::string& arguments) const {
    const Outcome outcome = run(arguments);
    INFO(outcome.errors);
    REQUIRE(outcome.exit_code == 0);
  }
  std::vector<std::string> maps(const std::string& folder) const {
    std::vector<std::string> bytes;
    for (const char* name : kMapFiles) bytes.push_back(read_file(*this / folder + "/" + name));
    return bytes;
  }
  std::size_t reused(const std::string& folder) const {
    const auto record = nlohmann::json::parse(read_file(*this / (folder + "/run.json")));
    return record.contains("reused") ? record["reused"]["results"].size() : 0;
  }
  fs::path unfinished() const { return *this / "out/unfinished.xgm"; }
  std::vector<fs::path> kept(const std::string& ending) const {
    std::vector<fs::path> files;
    if (!fs::exists(unfinished())) return files;
    for (const auto& entry : fs::directory_iterator(unfinished())) {
      const bool is_result = entry.path().filename() != "question.json";
      if (is_result && entry.path().extension() == ending) files.push_back(entry.path());
    }
    return files;
  }
  /// Ended by the signal as soon as something is kept.
  Outcome end_halfway(const std::string& arguments, int signal = SIGKILL) const {
    const std::jthread end([&](const std::stop_token& ended) {
      while (kept(".json").empty()) {
        if (ended.stop_requested()) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      ::kill(std::stoi(read_file(*this / "pid")), signal);
    });
    return run(arguments + " -o out --resume", "sh -c 'echo $$ > pid; exec \"$@\"' sh ");
  }
};

/// A map that is there is complete.
void check_whole_or_missing(const Desk& desk) {
  for (const char* name : kMapFiles) {
    const std::string file = "/" + std::string(name);
    if (!fs::exists(desk / "out" + file)) continue;
    CHECK(read_file(desk / "out" + file) == read_file(desk / "once" + file));
  }
}

}  // namespace

TEST_CASE("run --resume: ended at any moment, it goes on and gives the bytes of one run") {
  const Desk desk({140, 100}, 16);
  for (const std::string how : {"tmgm8 scene ", "tsgm8 scene --tiles 70x64 "}) {
    CAPTURE(how);
    const auto begin = std::chrono::steady_clock::now();
    desk.must_run(how + "-o once");
    const std::chrono::duration<double> once = std::chrono::steady_clock::now() - begin;
    const std::vector<std::string> maps = desk.maps("once");
    Random random(7);
    std::size_t reused = 0;
    int killed = 0;
    while (killed < 20) {
      const double after = once.count() * random.real(0.05, 1);
      const Outcome outcome = desk.run(how + "-o out --resume --log-level error",
                                       "timeout -s KILL " + std::to_string(after) + " ");
      if (outcome.exit_code != 0) {
        ++killed;
        check_whole_or_missing(desk);
        if (killed % 2 == 1) continue;  // also what goes on is ended
        desk.must_run(how + "-o out --resume");
      }
      reused += desk.reused("out");
      CHECK(desk.maps("out") == maps);
      CHECK_FALSE(fs::exists(desk.unfinished()));
      fs::remove_all(desk / "out");
    }
    CHECK(reused > 0);
  }
}

TEST_CASE("run --resume: another question is refused with what differs, or begun anew") {
  const Desk desk({240, 160}, 16);
  const std::string how = "tsgm8 scene --tiles 80x80";
  desk.end_halfway(how);
  REQUIRE_FALSE(desk.kept(".json").empty());
  check_usage_error(desk.run("tmgm8 scene --tiles 80x80 -o out --resume"),
                    "pipeline.matcher.matcher.matcher.aggregation");
  check_usage_error(desk.run("tsgm8 scene --tiles 120x80 -o out --resume"),
                    "out/unfinished.xgm was another one: --tiles differ");
  check_usage_error(desk.run(how + " --disparities 0:9 -o out --resume"), "disparities differ");
  check_usage_error(desk.run(how + " --nodata 7 -o out --resume"), "no data of the images differ");
  const std::string image = read_file(desk / "scene/im1.png");
  fs::copy_file(desk / "scene/im0.png", desk / "scene/im1.png",
                fs::copy_options::overwrite_existing);
  check_usage_error(desk.run(how + " -o out --resume"), ": right differ");
  desk.write("scene/im1.png", image);
  CHECK_FALSE(desk.kept(".json").empty());  // a refusal takes nothing away
  desk.must_run(how + " -o out");
  CHECK(desk.reused("out") == 0);
  CHECK_FALSE(fs::exists(desk.unfinished()));
  const std::vector<std::string> maps = desk.maps("out");
  desk.end_halfway(how);
  desk.must_run(how + " -o out --resume --threads 1");
  CHECK(desk.reused("out") > 0);
  CHECK(desk.maps("out") == maps);
}

TEST_CASE("run --resume: what is damaged is made again, with a note") {
  const Desk desk({240, 160}, 16);
  const std::string how = "tmgm8 scene --tiles 100x80";
  desk.must_run(how + " -o once");
  desk.end_halfway(how);
  const std::vector<fs::path> maps = desk.kept(".pfm");
  REQUIRE_FALSE(maps.empty());
  for (const fs::path& file : maps) {
    std::string bytes = read_file(file.string());
    bytes[bytes.size() / 2] ^= 1;
    write_file(file.string(), bytes);
  }
  const Outcome outcome = desk.run(how + " -o out --resume");
  CHECK(outcome.exit_code == 0);
  if (desk.kept(".json").size() > 0)
    CHECK(contains(outcome.errors, "is damaged, and is made again"));
  CHECK(desk.maps("out") == desk.maps("once"));
}

TEST_CASE("run --resume: one that is interrupted says how to go on") {
  const Desk desk({240, 160}, 16);
  const std::string how = "tsgm8 scene --tiles 80x80";
  const Outcome ended = desk.end_halfway(how, SIGINT);
  CHECK(ended.exit_code == 130);
  CHECK(contains(ended.errors, "interrupted; the same command with --resume goes on from "));
  const Outcome outcome = desk.run(how + " -o out --resume");
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.output, "reused:  "));
}

TEST_CASE(
    "run --resume: a full disk is one error, nothing is half-written, and room lets it go on") {
  const Desk desk;
  const std::string how = "tsgm8 scene --tiles 64x80 ";
  desk.must_run(how + "-o once");
  const bool tried = testing::goes_on_after_full_disk(
      desk.path(), "480k",
      [&](const std::string& before) { return desk.run(how + "-o out --resume", before); });
  if (!tried) return;
  CHECK(desk.maps("saved") == desk.maps("once"));
  CHECK(desk.reused("saved") > 0);
}

TEST_CASE("run --resume: what could be removed only in part is gone on with") {
  const Desk desk;
  const std::string how = "tsgm8 scene --tiles 64x80 ";
  desk.must_run(how + "-o once");
  desk.end_halfway(how);
  const Outcome outcome =
      desk.run(how + "-o out --resume",
               "unshare -rm sh -c 'cd out/unfinished.xgm && mkdir busy && mount -t tmpfs tmpfs "
               "busy || exit 99; cd ../..; \"$@\"' sh ");
  if (outcome.exit_code == 99 || contains(outcome.errors, "unshare")) {
    std::cout << "SKIPPED: a busy folder needs a file system that this user may mount" << std::endl;
    return;
  }
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.errors, "cannot be removed"));
  desk.must_run(how + "-o out --resume");
  CHECK(desk.maps("out") == desk.maps("once"));
  CHECK_FALSE(fs::exists(desk.unfinished()));
}

TEST_CASE("run --cache: only what comes after matching is done again, with the same bytes") {
  const Desk desk({160, 120}, 16);
  for (const std::string tiles : {"", " --tiles 80x64"}) {
    CAPTURE(tiles);
    const std::string how = "tmgm16_refined scene" + tiles;
    const std::string other = " --set 'postprocess=[{type: median, window: 5}]'";
    const std::string cached = " --cache cache -o ";
    desk.must_run(how + " -o once");
    desk.must_run(how + other + " -o other");
    desk.must_run(how + cached + "first");
    CHECK(desk.reused("first") == 0);
    CHECK(desk.maps("first") == desk.maps("once"));
    desk.must_run(how + other + cached + "changed");
    CHECK(desk.maps("changed") == desk.maps("other"));
    desk.must_run(how + cached + "again");
    CHECK(desk.maps("again") == desk.maps("once"));
    const std::size_t parts = tiles.empty() ? 1 : 1 + 4;  // coarse levels and tiles
    CHECK(desk.reused("changed") == parts);
    CHECK(desk.reused("again") == parts);
    desk.must_run(how + " --set matcher.scale=4" + cached + "matched");
    CHECK(desk.reused("matched") == 0);
    CHECK_FALSE(fs::exists(desk / "again/unfinished.xgm"));
  }
}

TEST_CASE("run --cache: runs side by side in one that is too small are right") {
  const Desk desk({160, 120}, 16);
  const std::string one =
      "run tsgm8 scene --tiles 80x64 --cache cache --cache-size 400KB --log-level warning";
  desk.must_run("tsgm8 scene --tiles 80x64 -o tiled");
  const Outcome outcome = testing::pipeline(
      desk.path(), one,
      "sh -c '\"$@\" -o a & first=$!; \"$@\" -o b; second=$?; wait $first && exit $second' sh ");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 0);
  for (const char* folder : {"a", "b"}) CHECK(desk.maps(folder) == desk.maps("tiled"));
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(desk / "cache")) bytes += entry.file_size();
  CHECK(bytes <= 400'000);
  CHECK(bytes > 0);
}

TEST_CASE("run --resume and --cache: mistakes are exit 2, before any work") {
  const Desk desk({60, 40}, 8);
  check_usage_error(desk.run("tsgm8 scene --resume --dump '*' -o out"),
                    "leave out --report, --dump");
  check_usage_error(desk.run("tsgm8 scene --cache c --report -o out"),
                    "leave out --report, --dump");
  check_usage_error(desk.run("tsgm8 --resume -o out"), "--resume: needs images in files");
  check_usage_error(desk.run("tsgm8 scene --resume --cache c -o out"), "--cache");
  check_usage_error(desk.run("tsgm8 scene --cache-size 1GB -o out"), "--cache");
  check_usage_error(desk.run("tsgm8 scene --cache c --cache-size big -o out"), "--cache-size");
  check_usage_error(desk.run("tsgm8 scene --cache scene/im0.png -o out"), "--cache scene/im0.png");
  CHECK_FALSE(fs::exists(desk / "out/run.json"));
}
