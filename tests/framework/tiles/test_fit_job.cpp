// SPDX-License-Identifier: Apache-2.0
// What is found on the whole scene is found once, and handed to the jobs.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "framework/tiles/job_desk.hpp"
#include "xgm/base/json.hpp"

using namespace xgm;
using namespace xgm::tiles;
using xgm::testing::contains;
using xgm::testing::error_of;

namespace {

/// Brightens by the lowest grey level of the match image, whose search it counts.
class Brighten final : public Preprocess {
 public:
  struct Parameters {
    bool hands_on = true;
  };
  static void describe(Parameters& p, ParameterSet& set) {
    set.add("hands_on", p.hands_on, "Whether other processes are told.");
  }
  explicit Brighten(Parameters p) : hands_on_(p.hands_on) {}

  static inline int fits = 0;

  ImagePair run(const ImagePair& pair, const Context& context) const override {
    return fitted(PairInMemory(pair), context)->run(pair, {});
  }
  std::shared_ptr<const PartPreprocess> fitted(const PairWindows& scene,
                                               const Context&) const override {
    if (scene.size().width > 200) ++fits;  // not the small run of the plan
    double low = 0;
    cv::minMaxIdx(scene.read({{}, scene.size()}).match.planes.front(), &low);
    return std::make_shared<Part>(low / 3, hands_on_);
  }
  std::shared_ptr<const PartPreprocess> restored(const std::string& state,
                                                 cv::Size) const override {
    return std::make_shared<Part>(Json::parse(state).at("level").number(), hands_on_);
  }

 private:
  struct Part final : PartPreprocess {
    Part(double level, bool hands_on) : level_(level), hands_on_(hands_on) {}
    int margin() const override { return 0; }
    ImagePair run(const ImagePair& part, cv::Point) const override {
      ImagePair result = part;
      for (cv::Mat1f& plane : result.match.planes) plane = cv::Mat1f(plane + level_);
      return result;
    }
    std::string state() const override { return hands_on_ ? Json{{"level", level_}}.dump() : ""; }
    double level_;
    bool hands_on_;
  };
  bool hands_on_;
};

/// What a record of the job says that it has found.
std::string found_in(const std::string& record) {
  const std::size_t begin = record.find("\"found\"");
  return record.substr(begin, record.find("\"job\"") - begin);
}

}  // namespace

TEST_CASE("jobs: stages are fitted to the whole scene once, by the job 'fit'") {
  for (const bool hands_on : {true, false}) {
    CAPTURE(hands_on);
    Registry registry = Registry::with_builtins();
    registry.add<Brighten>("brighten", "For this test.");
    const std::string text =
        "preprocess: [{type: brighten, hands_on: " + std::string(hands_on ? "true" : "false") +
        "}]\nmatcher: {type: semi_global, cost: absolute_difference, penalty: {type: constant, p1: "
        "8, p2: 32}, aggregation: sgm}\n";
    const LoadedPipeline loaded = load_pipeline_text(text, "brightened.yaml", registry);
    REQUIRE(loaded.pipeline);
    Brighten::fits = 0;
    const Desk desk(*loaded.pipeline);
    CHECK(desk.manifest.jobs.front().name == "fit");
    CHECK(desk.manifest.jobs.front().memory_bytes > 1e6);
    CHECK(Brighten::fits == 0);  // planning is quick
    for (const TileJob& job : desk.manifest.jobs) CHECK(desk.run(job.name));
    // What cannot be handed on is fitted by each job, with the same result.
    CHECK(Brighten::fits == (hands_on ? 1 : static_cast<int>(desk.manifest.jobs.size())));
    join_jobs(desk.manifest, desk / "joined");
    desk.match_at_once(desk / "at_once");
    check_same_files(desk / "joined", desk / "at_once");
  }
}

TEST_CASE("jobs: without what 'fit' has found, or with a damaged one, nothing is matched") {
  const Desk desk("tmgm16_refined");
  const std::string fit = desk / "work/jobs/fit.json";
  const auto error = [&] { return error_of([&] { desk.run("coarse"); }); };
  const std::string remedy = "pipeline tiles run " + desk.manifest.file;
  CHECK(contains(error(), "not done: fit; " + fit + " is missing"));
  CHECK(contains(error(), remedy));
  CHECK(desk.run("fit"));
  CHECK_FALSE(desk.run("fit"));
  const std::string bytes = read_file(fit);
  CHECK(contains(bytes, "\"stage\": \"ransac_deskew\""));
  std::string other = bytes;
  other[other.find("\"c\":") + 6] ^= 1;  // a digit
  for (const std::string& damaged : {other, bytes.substr(0, bytes.size() / 2), std::string("{}")}) {
    write_file(fit, damaged);
    CAPTURE(damaged);
    CHECK(contains(error(), fit + ": "));
    CHECK(contains(error(), "is damaged; make it again with " + remedy + " fit"));
    CHECK(desk.run("fit"));
    CHECK(found_in(read_file(fit)) == found_in(bytes));
  }
  CHECK(desk.run("coarse"));
  std::filesystem::remove(fit);
  CHECK(contains(error_of([&] { desk.run("tile_1_1"); }), "not done: fit; "));
}

TEST_CASE("jobs: what the plan has found in the images, jobs read and do not look for") {
  Desk desk("sgm8");
  // 16 bits of which 10 are used, as the last rows tell, a mask, and a mark of no data.
  cv::Mat1w left(171, 261), right(171, 261);
  cv::RNG random(3);
  for (cv::Mat1w* image : {&left, &right}) random.fill(*image, cv::RNG::UNIFORM, 10, 250);
  right(cv::Rect(0, 0, 255, 171)).copyTo(left(cv::Rect(6, 0, 255, 171)));
  left(170, 260) = 1000;
  right(cv::Rect(20, 20, 40, 30)).setTo(0);
  cv::Mat1b mask(171, 261, std::uint8_t{255});
  mask(cv::Rect(150, 100, 30, 30)).setTo(0);
  PairFiles& images = desk.files.images;
  images = {.left = desk / "left.png",
            .right = desk / "right.png",
            .left_mask = desk / "mask.png",
            .no_data = {0}};
  REQUIRE(cv::imwrite(images.left, left));
  REQUIRE(cv::imwrite(images.right, right));
  write_png(images.left_mask, mask);
  desk.plan();
  const JobManifest read = read_manifest(desk.manifest.file);
  CHECK(read.look.gain == 255.0 / 1023);
  CHECK(read.look.left.masked_pixels == 900);
  CHECK(read.look.right.masked_pixels == 1200);
  for (const TileJob& job : read.jobs) CHECK(run_job(read, job, desk.pipeline));
  join_jobs(read, desk / "joined");
  desk.match_at_once(desk / "at_once");
  check_same_files(desk / "joined", desk / "at_once");
  // Jobs go by the manifest: with another gain the map is another one.
  JobManifest other = read;
  other.look.gain = 0.01;
  for (const TileJob& job : other.jobs) CHECK(run_job(other, job, desk.pipeline));
  join_jobs(other, desk / "other");
  CHECK(read_file(desk / "other/disparity.pfm") != read_file(desk / "joined/disparity.pfm"));
}
