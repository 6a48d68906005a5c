// SPDX-License-Identifier: Apache-2.0
// Jobs in any order beside one process that matches the same tiles.
#include <doctest/doctest.h>

#include <algorithm>

#include "framework/tiles/job_desk.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using namespace xgm::tiles;
using xgm::testing::builtins;
using xgm::testing::contains;
using xgm::testing::error_of;

TEST_CASE("jobs in any order give the bytes of one process") {
  for (const char* name : {"tmgm16_refined", "sgm8"}) {
    CAPTURE(std::string(name));
    const Desk desk(name);
    std::vector<TileJob> jobs = desk.manifest.jobs;
    // sgm8 has nothing that looks at the whole, and no pyramid.
    const std::vector<std::string> before =
        std::string(name) == "sgm8" ? Names{} : Names{"fit", "coarse"};
    CHECK(jobs.size() == 6 + before.size());
    CHECK(jobs.back().needs == before);
    for (const std::string& first : before) CHECK(desk.run(first));
    std::reverse(jobs.begin(), jobs.end());
    for (const TileJob& job : jobs) CHECK(desk.run(job.name) == !job.place.empty());
    const MapSummary summary = join_jobs(desk.manifest, desk / "joined");
    desk.match_at_once(desk / "at_once");
    check_same_files(desk / "joined", desk / "at_once");
    CHECK(summary.density() > 0.5);
  }
}

TEST_CASE("jobs carry the confidence of their maps, and joining joins it") {
  const std::string text =
      "xgm: 1\nmatcher:\n  type: pyramid\n  scale: 2\n  matcher:\n    type: left_right\n"
      "    confidence: {type: weighted, confidences: [so_far, left_right_difference], weights: [1, "
      "1]}\n    matcher: {type: semi_global, cost: census, penalty: constant, aggregation: sgm, "
      "confidence: peak_ratio}\n";
  const LoadedPipeline loaded = load_pipeline_text(text, "sure.yaml", builtins());
  REQUIRE(loaded.pipeline);
  const Desk desk(*loaded.pipeline);
  for (const TileJob& job : desk.manifest.jobs) desk.run(job.name);
  join_jobs(desk.manifest, desk / "joined");
  desk.match_at_once(desk / "at_once");
  check_same_files(desk / "joined", desk / "at_once");
  CHECK(read_file(desk / "joined/confidence.pfm") == read_file(desk / "at_once/confidence.pfm"));
  const cv::Mat1f sure = read_pfm(desk / "joined/confidence.pfm");
  const cv::Mat1f map = read_pfm(desk / "joined/disparity.pfm");
  CHECK(cv::countNonZero((sure == sure) != (map == map)) == 0);  // where there is a disparity
}

TEST_CASE("jobs: the manifest is read as it was written, with what each job takes") {
  const Desk desk("tsgm8");
  const JobManifest read = read_manifest(desk.manifest.file);
  CHECK(read.pipeline_file == desk.pipeline.file());
  CHECK(read.size == desk.manifest.size);
  CHECK(read.disparities == desk.manifest.disparities);
  CHECK(read.tiles.size == desk.manifest.tiles.size);
  CHECK(read.tiles.coarse_pixels == desk.manifest.tiles.coarse_pixels);
  REQUIRE(read.jobs.size() == desk.manifest.jobs.size());
  for (std::size_t i = 0; i < read.jobs.size(); ++i) {
    CHECK(read.jobs[i].name == desk.manifest.jobs[i].name);
    CHECK(read.jobs[i].place == desk.manifest.jobs[i].place);
    CHECK(read.jobs[i].memory_bytes > 1e6);
    CHECK(read.jobs[i].seconds > 0);
  }
  // Also the results are the same question's.
  CHECK(run_job(read, read.jobs.front(), desk.pipeline));
  CHECK(is_done(desk.manifest, desk.manifest.jobs.front()));
}

TEST_CASE("jobs: done ones are not done again, damaged results and those of other questions are") {
  Desk desk("tsgm8");
  CHECK(contains(error_of([&] { desk.run("tile_1_1"); }), "not done: coarse"));
  CHECK(desk.run("coarse"));
  CHECK_FALSE(desk.run("coarse"));
  const std::string result = desk / "work/jobs/coarse_1.pfm";
  const std::string bytes = read_file(result);
  std::string damaged = bytes;
  damaged[bytes.size() / 2] ^= 1;
  for (const std::string& now : {damaged, bytes.substr(0, 100)}) {
    write_file(result, now);
    CHECK_FALSE(is_done(desk.manifest, desk.manifest.jobs.front()));
    CHECK(desk.run("coarse"));
    CHECK(read_file(result) == bytes);
  }
  CHECK(desk.run("tile_1_1"));
  CHECK(contains(error_of([&] { join_jobs(desk.manifest, desk / "joined"); }), "tile_1_2, "));
  JobManifest other = desk.manifest;
  other.tiles.halo = 64;
  CHECK_FALSE(is_done(other, other.jobs.front()));
}

TEST_CASE(
    "jobs: a tile finds damages of the rows of the coarse maps that it needs, and only these") {
  Desk desk("tsgm8");
  desk.manifest.tiles.halo = 8;
  write_manifest(desk.manifest);
  CHECK(desk.run("coarse"));
  const std::string last = desk / "work/jobs/coarse_4.pfm";  // of 86 rows, 24 in each strip
  CHECK_FALSE(std::filesystem::exists(desk / "work/jobs/coarse_5.json"));
  const std::string bytes = read_file(last);
  std::string damaged = bytes;
  damaged[bytes.size() / 2] ^= 1;
  write_file(last, damaged);
  CHECK(desk.run("tile_1_1"));
  CHECK(contains(error_of([&] { desk.run("tile_2_1"); }), "coarse_4.json: this result, or a file"));
  std::filesystem::remove(last);
  CHECK(contains(error_of([&] { desk.run("tile_2_1"); }), "run " + desk.manifest.file + " coarse"));
  std::filesystem::remove(desk / "work/jobs/coarse_4.json");  // which the job's record names
  CHECK(contains(error_of([&] { desk.run("tile_1_2"); }), "coarse.json: this result, or a file"));
  CHECK(desk.run("coarse"));
  CHECK(read_file(last) == bytes);
  for (const TileJob& job : desk.manifest.jobs) desk.run(job.name);
  join_jobs(desk.manifest, desk / "joined");
  desk.match_at_once(desk / "at_once");
  check_same_files(desk / "joined", desk / "at_once");
}

TEST_CASE("jobs: a changed image, an unknown job and what is no manifest are refused") {
  const Desk desk("sgm8");
  CHECK(contains(error_of([&] { desk.run("tile_9_9"); }), "there is no job 'tile_9_9'"));
  desk.write("bad.json", "{\"format\": 1}");
  CHECK(contains(error_of([&] { read_manifest(desk / "bad.json"); }), "is no manifest of jobs"));
  write_png(desk.files.images.right, cv::Mat1b(desk.manifest.size, std::uint8_t{9}));
  CHECK(contains(error_of([&] { desk.run("tile_1_1"); }), "right.png: has changed since"));
}
