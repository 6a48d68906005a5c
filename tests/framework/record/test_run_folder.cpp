// SPDX-License-Identifier: Apache-2.0
// A folder that runs share holds the files of one of them, and what is the user's stays.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "framework/record/noise.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/evaluation/recorded_run.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::noise;
using xgm::testing::noise_pipeline;
using xgm::testing::TemporaryFolder;

namespace fs = std::filesystem;

namespace {

using Names = std::set<std::string>;

const Names kPlain{"disparity.pfm", "disparity.png", "run.json", "status.png"};

struct Output : TemporaryFolder {
  RecordedRun run(RecordRequest request = {}, const RunOptions& options = {}) const {
    request.folder = path();
    SceneRequest scene = noise(9);
    std::get<Scene>(scene.scene).calibration = Calibration{.focal = 100, .baseline = 10};
    return record_scene(noise_pipeline(), scene, request, options);
  }
  /// With everything that a run can write.
  RecordedRun full_run() const {
    return run({.dump = "*.cost",
                .report = true,
                .explained = {.every = 20},
                .depth = {*this / "points.ply", ""}});
  }
  Names names() const {
    Names names;
    for (const auto& entry : fs::recursive_directory_iterator(path())) {
      names.insert(entry.path().lexically_relative(path()).string());
    }
    return names;
  }
  nlohmann::json record() const { return nlohmann::json::parse(read_file(*this / "run.json")); }
};

struct Failing : Observer {
  explicit Failing(std::string path) : path_(std::move(path)) {}
  void stage_end(const StagePlace& place, const StageStatistics&, const Artifact&) override {
    if (place.path == path_) throw Error("no more");
  }
  std::string path_;
};

}  // namespace

TEST_CASE("run.json lists the files that the run wrote to its folder, with their sizes") {
  const Output output;
  output.full_run();
  Names listed{"run.json", "dump"};
  const auto record = output.record();
  for (const auto& file : record["outputs"]) {
    const std::string name = file["file"];
    listed.insert(name);
    CHECK(file["bytes"] == fs::file_size(output / name));
  }
  CHECK(listed == output.names());
  CHECK(listed.contains("points_depth.tiff"));
  CHECK(listed.contains("dump/matcher.cost.npy"));
}

TEST_CASE("what an earlier run left and this one does not renew is removed") {
  const Output output;
  output.full_run();
  output.write("notes.txt", "mine");
  output.run();
  Names expected = kPlain;
  expected.insert("notes.txt");
  CHECK(output.names() == expected);
}

TEST_CASE("files that no run wrote stay, and are refused where they would pass for results") {
  const Output output;
  const auto check_refused = [&](const std::string& name, const std::string& reason) {
    const Names before = output.names();
    const std::string message = error_of([&] { output.run(); });
    CAPTURE(message);
    CHECK(contains(message, name + " " + reason));
    CHECK(read_file(output / name) == "mine");
    CHECK(output.names() == before);
  };
  fs::create_directory(output / "dump");
  for (const char* name : {"dump/mine.npy", "report.html", "explain.json", "confidence.pfm"}) {
    output.write(name, "mine");
    check_refused(name, "is no file that run.json lists");
    fs::remove(output / name);
  }
  output.full_run();
  for (const char* name : {"report.html", "points.ply", "dump/matcher.cost.npy"}) {
    output.full_run();
    output.write(name, "mine");
    check_refused(name, "has been changed");
    fs::remove(output / name);
  }
}

TEST_CASE("a list of outputs that leads out of the folder removes nothing there") {
  const TemporaryFolder other;
  other.write("mine", "mine");
  const Output output;
  nlohmann::json list;
  for (const std::string& name :
       {other / "mine", fs::relative(other / "mine", output.path()).string()}) {
    list["outputs"].push_back({{"file", name}, {"bytes", 4}});
  }
  output.write("run.json", list.dump());
  output.run();
  CHECK(read_file(other / "mine") == "mine");
  CHECK(output.names() == kPlain);
}

TEST_CASE("a run that fails before it writes leaves an earlier run whole") {
  const Output output;
  output.full_run();
  const Names before = output.names();
  const std::string record = read_file(output / "run.json");
  Failing failing("matcher.aggregation");
  CHECK(contains(error_of([&] { output.run({}, {.observer = &failing}); }), "no more"));
  CHECK(output.names() == before);
  CHECK(read_file(output / "run.json") == record);
}

TEST_CASE("dumps of a run that failed are kept for inspection, and the next run removes them") {
  const Output output;
  output.full_run();
  Failing failing("matcher.aggregation");
  CHECK_THROWS(output.run({.dump = "*"}, {.observer = &failing}));
  CHECK(output.names().contains("dump/matcher.cost.npy"));
  CHECK_FALSE(output.names().contains("run.json"));
  CHECK_FALSE(output.names().contains("disparity.pfm"));
  output.run();
  CHECK(output.names() == kPlain);
}

TEST_CASE("a run that is cancelled leaves nothing") {
  const Output output;
  std::stop_source stop;
  struct Stopper : Observer {
    explicit Stopper(std::stop_source& source) : source_(source) {}
    void stage_end(const StagePlace& place, const StageStatistics&, const Artifact&) override {
      if (place.path == "matcher.aggregation") source_.request_stop();
    }
    std::stop_source& source_;
  } stopper(stop);
  CHECK_THROWS_AS(output.run({.dump = "*"}, {.observer = &stopper, .stop = stop.get_token()}),
                  Cancelled);
  CHECK(output.names().empty());
}

TEST_CASE("a report that cannot be written takes no map away") {
  const Output output;
  struct Blocker : Observer {
    explicit Blocker(std::string folder) : folder_(std::move(folder)) {}
    void stage_end(const StagePlace&, const StageStatistics&, const Artifact&) override {
      fs::create_directory(folder_);
    }
    std::string folder_;
  } blocker(output / "report.html");
  CHECK(contains(error_of([&] { output.run({.report = true}, {.observer = &blocker}); }),
                 "report.html: cannot be written"));
  CHECK(read_pfm(output / "disparity.pfm")(12, 60) == 9);
  CHECK_FALSE(output.names().contains("run.json"));
  fs::remove(output / "report.html");
  output.run();
  CHECK(output.names() == kPlain);
}

TEST_CASE("a folder where a run is at work takes no other") {
  const Output output;
  output.full_run();
  const Names before = output.names();
  {
    const FolderLock other(output.path());
    CHECK_THROWS_AS(output.run(), UsageError);
    CHECK(contains(error_of([&] { output.run(); }), "another run or bench writes to"));
  }
  CHECK(output.names() == before);
  output.run();
  CHECK(output.names() == kPlain);
}
