// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/pipeline/question.hpp"
#include "xgm/pipeline/unfinished_run.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::identical;
using xgm::testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

const Json kQuestion = {{"left", "a1"}, {"pipeline", {{"matcher", {{"scale", 4}, {"p1", 8}}}}}};

DisparityMap map_of(float value) {
  DisparityMap map({9, 7}, Status::occluded);
  map.set(3, 4, value);
  return map;
}

struct Desk : TemporaryFolder {
  std::string folder = *this / "unfinished.xgm";
  std::vector<std::string> told{};

  UnfinishedRun run(bool resume, const Json& question = kQuestion) {
    return UnfinishedRun(folder, question,
                         {.resume = resume,
                          .after_seconds = 1000,
                          .tell = [this](const auto& text) { told.push_back(text); }});
  }
  fs::path some_file(const std::string& ending) const {
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(ending) && name != "question.json") return entry.path();
    }
    return {};
  }
};

}  // namespace

TEST_CASE("an unfinished run is gone on with, and leaves nothing when it has ended") {
  Desk desk;
  {
    UnfinishedRun first = desk.run(true);
    CHECK_FALSE(first.find("a").has_value());
    first.keep("a", {map_of(1), map_of(2)});
    first.keep_part("tile_1_1", map_of(3));
  }
  UnfinishedRun second = desk.run(true);
  const auto found = second.find("a");
  REQUIRE(found.has_value());
  CHECK(identical(found->forward, map_of(1)));
  CHECK(identical(found->reverse.value(), map_of(2)));
  CHECK(identical(second.find_part("tile_1_1").value(), map_of(3)));
  CHECK_FALSE(second.find("b").has_value());
  CHECK(second.reused() == std::vector<std::string>{"a", "tile_1_1"});
  second.remove();
  CHECK_FALSE(fs::exists(desk.folder));
  CHECK(desk.told.empty());
}

TEST_CASE("a run that was not asked to go on begins anew, and keeps what costs little beside it") {
  Desk desk;
  desk.run(true).keep("a", {map_of(1), {}});
  UnfinishedRun anew = desk.run(false);
  CHECK_FALSE(fs::exists(desk.folder));
  CHECK_FALSE(anew.find("a").has_value());
  anew.keep("a", {map_of(1), {}});
  CHECK_FALSE(fs::exists(desk.folder));
  UnfinishedRun long_run(desk.folder, kQuestion, {.after_seconds = 0, .share = 0});
  long_run.keep("a", {map_of(1), {}});
  CHECK_FALSE(fs::exists(desk.folder));
  UnfinishedRun longer(desk.folder, kQuestion, {.after_seconds = 0, .share = 1e9});
  longer.keep("a", {map_of(1), {}});
  CHECK(desk.run(true).find("a").has_value());
}

TEST_CASE("a run of another question is refused with what differs, and nothing of it is lost") {
  Desk desk;
  desk.run(true).keep("a", {map_of(1), {}});
  const Json other = {
      {"left", "b2"}, {"right", "c3"}, {"pipeline", {{"matcher", {{"scale", 8}, {"p1", 8}}}}}};
  CHECK(contains(error_of([&] { desk.run(true, other); }),
                 "left, pipeline.matcher.scale, right differ; ask for the same again"));
  CHECK(desk.run(true).find("a").has_value());
  CHECK(difference(kQuestion, kQuestion).empty());
}

TEST_CASE("a damaged result is told of and found no more; a damaged question begins anew") {
  Desk desk;
  desk.run(true).keep("a", {map_of(1), {}});
  std::string bytes = read_file(desk.some_file(".pfm").string());
  bytes.back() ^= 1;
  write_file(desk.some_file(".pfm").string(), bytes);
  CHECK_FALSE(desk.run(true).find("a").has_value());
  REQUIRE(desk.told.size() == 1);
  CHECK(contains(desk.told[0], "what was kept of a is damaged"));
  desk.run(true).keep("a", {map_of(1), {}});
  CHECK(desk.run(true).find("a").has_value());
  write_file(desk.folder + "/question.json", "{\"question\": ");
  CHECK_FALSE(desk.run(true).find("a").has_value());
  CHECK(contains(desk.told.back(), "the run begins anew"));
}

TEST_CASE("what a run has decided holds for the run that goes on") {
  Desk desk;
  const auto decide = [](UnfinishedRun run, int value) {
    const Json decided = run.decided("tiles", [&] { return Json(value); });
    run.keep("a", {map_of(1), {}});
    return decided.number();
  };
  CHECK(decide(desk.run(true), 500) == 500);
  CHECK(decide(desk.run(true), 300) == 500);
  CHECK(decide(desk.run(false), 300) == 300);
}

TEST_CASE("a folder of that name that no run has made is not removed") {
  Desk desk;
  fs::create_directory(desk.folder);
  write_file(desk.folder + "/thesis.txt", "all of it");
  CHECK(contains(error_of([&] { desk.run(false); }), "is not what a run has left"));
  CHECK(fs::exists(desk.folder + "/thesis.txt"));
}
