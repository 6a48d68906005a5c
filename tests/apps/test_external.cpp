// SPDX-License-Identifier: Apache-2.0
// Programs of others in runs and benches, as a user meets them.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

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
  void pipeline_of(const std::string& name, const std::string& matcher) const {
    write(name, "matcher: {type: external, time_limit: 2, " + matcher + "}\n");
  }
  std::string program(const std::string& name, const std::string& script) const {
    return "command: [sh, '" + write(name, "folder=$(dirname \"$1\")\n" + script + "\n") + "']";
  }
  Outcome run(const std::string& arguments, const std::string& before = "") const {
    return pipeline(path(), arguments, "TMPDIR='" + (*this / "tmp") + "' " + before);
  }
  bool left_nothing() const { return std::filesystem::is_empty(*this / "tmp"); }
};

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
  desk.pipeline_of("floods.yaml", desk.program("floods.sh", "exec yes"));
  desk.pipeline_of("half.yaml", desk.program("half.sh",
                                             "head -c 99 /dev/zero > "
                                             "\"$folder/disparity.npy\""));
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
  CHECK(contains(bench.output + bench.errors, "ended by signal 11"));
  CHECK(contains(bench.output + bench.errors, "is no file of NumPy"));
  CHECK(desk.left_nothing());
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
