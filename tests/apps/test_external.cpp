// SPDX-License-Identifier: Apache-2.0
// Programs of others in runs and benches, as a user meets them.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "apps/program.hpp"
#include "apps/small_scene.hpp"
#include "external/programs.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

struct Desk : SmallScene {
  Desk() {
    std::filesystem::create_directory(*this / "tmp");
    std::filesystem::create_directory(*this / "data");
    for (const char* name : {"data/one", "data/two"}) {
      std::filesystem::copy(*this / "scene", *this / name);
    }
  }
  void pipeline_of(const std::string& name, const std::string& matcher, int seconds = 2) const {
    write(name, "matcher: {type: external, time_limit: " + std::to_string(seconds) + ", " +
                    matcher + "}\n");
  }
  std::string program(const std::string& name, const std::string& script) const {
    return "command: [sh, '" + write(name, "folder=$(dirname \"$1\")\n" + script + "\n") + "']";
  }
  Outcome run(const std::string& arguments, const std::string& before = "") const {
    return pipeline(path(), arguments, "TMPDIR='" + (*this / "tmp") + "' " + before);
  }
  bool left_nothing() const { return std::filesystem::is_empty(*this / "tmp"); }
};

/// What programs were asked, but for the folder of each request.
using Requests = std::multiset<std::string>;

Requests requests_in(const std::string& folder) {
  Requests requests;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    auto json = nlohmann::json::parse(read_file(entry.path().string()));
    json.erase("folder");
    requests.insert(json.dump());
  }
  return requests;
}

}  // namespace

TEST_CASE("run: an external matcher gives a map and is planned without being started") {
  const Desk desk;
  desk.pipeline_of("p.yaml", honest("match"));
  const Outcome run = desk.run("run p.yaml data/one -o out --memory-limit 2GB");
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  CHECK(std::filesystem::exists(desk / "out/disparity.pfm"));
  CHECK(desk.left_nothing());
  desk.pipeline_of("never.yaml", desk.program("never.sh", "echo > started; exit 1"));
  const Outcome plan = desk.run("plan never.yaml data/one");
  INFO(plan.errors);
  CHECK(plan.exit_code == 0);
  CHECK_FALSE(std::filesystem::exists(desk / "started"));
}

TEST_CASE("bench: programs that hang, crash, flood and write half a file fail alone") {
  const Desk desk;
  desk.pipeline_of("good.yaml", honest("match"));
  desk.pipeline_of("hangs.yaml", desk.program("hangs.sh", "sleep 1000"));
  desk.pipeline_of("crashes.yaml", desk.program("crashes.sh", "kill -SEGV $$"));
  desk.pipeline_of("floods.yaml", desk.program("floods.sh", "exec yes"), 60);
  write_npy(desk / "whole.npy", cv::Mat1f(24, 40, 3.0F));
  const std::string half_a_map =
      "head -c 2000 '" + (desk / "whole.npy") + "' > \"$folder/disparity.npy\"";
  desk.pipeline_of("half.yaml", desk.program("half.sh", half_a_map));
  const Outcome bench = desk.run(
      "bench --pipelines good.yaml,hangs.yaml,crashes.yaml,floods.yaml,half.yaml,sgm8 --data data "
      "--output b");
  INFO(bench.output, bench.errors);
  CHECK(bench.exit_code == 1);
  const auto json = nlohmann::json::parse(read_file(desk / "b/bench.json"));
  int done = 0, failed = 0;
  for (const auto& cell : json["cells"]) {
    const std::string pipeline_name = cell["pipeline"];
    const bool good = pipeline_name == "good" || pipeline_name == "sgm8";
    CAPTURE(pipeline_name);
    CHECK((cell["state"] == "done") == good);
    good ? ++done : ++failed;
  }
  CHECK(done == 4);
  CHECK(failed == 8);
  const std::string said = bench.output + bench.errors;
  CHECK(contains(said, "did not end within 2 s and was ended; raise time_limit"));
  CHECK(contains(said, "ended by signal 11"));
  CHECK(contains(said, "printed more than 64 MB and was ended"));
  CHECK(contains(said, "is cut short"));
  CHECK(desk.left_nothing());
}

TEST_CASE("tiles: a program is told of the scene what it is told in a whole run, in jobs, too") {
  const SmallScene desk({200, 130});
  const std::string script =
      desk.write("keep.sh", "cp \"$1\" \"$(mktemp $KEPT/XXXXXX)\"\nexec '" XGM_BINARY_DIR
                            "/bin/xgm_honest_program' match \"$1\"\n");
  desk.write(
      "p.yaml",
      "disparities: [0, 7]\nmatcher: {type: pyramid, scale: 4, search_range: {type: min_max, "
      "window: 7, relaxation: 2}, matcher: {type: external, range_maps: true, command: [sh, '" +
          script + "']}}\n");
  const auto told = [&](const std::string& name, const std::vector<std::string>& calls) {
    std::filesystem::create_directory(desk / name);
    for (const std::string& arguments : calls) {
      const Outcome outcome = desk.call(arguments, "KEPT='" + (desk / name) + "' ");
      INFO(arguments, outcome.errors);
      REQUIRE(outcome.exit_code == 0);
    }
    return requests_in(desk / name);
  };
  const Requests whole = told("whole", {"run p.yaml scene -o once"});
  const Requests tiles = told("tiles", {"run p.yaml scene --tiles 128x96 -o at_once"});
  std::vector<std::string> calls{"tiles plan p.yaml scene --tiles 128x96 -o work"};
  for (const char* job : {"coarse", "tile_1_1", "tile_1_2", "tile_2_1", "tile_2_2"}) {
    calls.push_back("tiles run work/manifest.json " + std::string(job));
  }
  const Requests jobs = told("jobs", calls);
  CHECK(whole.size() == 3);  // one of each level
  CHECK(tiles.size() > 4);
  CHECK(jobs == tiles);
  for (const Requests* requests : {&whole, &tiles}) {
    for (const std::string& request : *requests) {
      CAPTURE(request);
      const auto json = nlohmann::json::parse(request);
      const double scale = json["scale"];
      CHECK(json["scene"] == "scene");
      CHECK(json["calibration"]["baseline"] == 160);
      CHECK(json["calibration"]["focal"].get<double>() * scale == 36);
      const double left = 20 - ((json["calibration"]["cx"].get<double>() + 0.5) * scale - 0.5);
      CHECK(left >= 0);  // of the window, in px of the scene
      CHECK(left == std::floor(left));
      CHECK(left < 200);
      if (requests == &whole) CHECK(left == 0);
    }
  }
}

TEST_CASE("run: a signal ends a program that hangs, and nothing is left") {
  const Desk desk;
  desk.write("p.yaml", "matcher: {type: external, " +
                           desk.program("hangs.sh", "echo $$ > id; exec sleep 1000") + "}\n");
  const Outcome run = desk.run("run p.yaml data/one -o out", "timeout -s INT 2 ");
  INFO(run.errors);
  CHECK(run.exit_code != 0);
  CHECK(std::filesystem::exists(desk / "id"));
  CHECK(desk.left_nothing());
  CHECK_FALSE(std::filesystem::exists("/proc/" + read_file(desk / "id")));
}
