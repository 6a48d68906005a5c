// SPDX-License-Identifier: Apache-2.0
// pipeline synth, as a user meets it.
#include <doctest/doctest.h>

#include <filesystem>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;

namespace {

Outcome call(const TemporaryFolder& folder, const std::string& arguments) {
  return xgm::testing::pipeline(folder.path(), arguments, "timeout 60 ");
}

const std::string kSmall = " --size 64x48 --disparities 0:15 ";

}  // namespace

TEST_CASE("synth: scenes that run understands, one after the other") {
  const TemporaryFolder folder;
  const Outcome made = call(folder, "synth out --count 2 --fault exposure=1.3 noise=2" + kSmall);
  INFO(made.errors);
  CHECK(made.exit_code == 0);
  CHECK(contains(made.output, "scene_0002: seed 2"));
  const std::string scene = "out/scene_0002";
  const Outcome run = call(folder, "run sgm8 " + scene + " --truth " + scene +
                                       "/disp0GT.pfm --truth-mask " + scene + "/mask0nocc.png");
  INFO(run.errors);
  CHECK(run.exit_code == 0);
  CHECK(contains(run.output, "non-occluded"));
}

TEST_CASE("synth: the same seed, the same bytes, whatever stands before it and how many threads") {
  const TemporaryFolder folder;
  call(folder, "synth one --count 3 --seed 4 --threads 1" + kSmall);
  call(folder, "synth other --seed 6 --threads 2" + kSmall);
  for (const char* name : {"im0.png", "im1.png", "disp0GT.pfm", "disp1GT.pfm", "mask0nocc.png",
                           "mask1nocc.png", "calib.txt", "scene.json"}) {
    CAPTURE(name);
    CHECK(read_file(folder / (std::string("one/scene_0003/") + name)) ==
          read_file(folder / (std::string("other/scene_0001/") + name)));
  }
  CHECK(read_file(folder / "one/scene_0001/im0.png") !=
        read_file(folder / "one/scene_0002/im0.png"));
}

TEST_CASE("synth: a folder that is not empty needs --force, and keeps what is no scene") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "full");
  folder.write("full/letter.txt", "dear");
  const Outcome refused = call(folder, "synth full" + kSmall);
  CHECK(refused.exit_code == 2);
  CHECK(contains(refused.errors, "full: is not empty; choose another folder, or add --force"));
  CHECK(call(folder, "synth full --force" + kSmall).exit_code == 0);
  CHECK(call(folder, "synth full --force --seed 9" + kSmall).exit_code == 0);
  CHECK(contains(read_file(folder / "full/scene_0001/scene.json"), "\"seed\": 9"));
  CHECK(read_file(folder / "full/letter.txt") == "dear");
}

TEST_CASE("synth: a file in the way is told") {
  const TemporaryFolder folder;
  folder.write("letter.txt", "dear");
  const Outcome refused = call(folder, "synth letter.txt" + kSmall);
  CHECK(refused.exit_code == 2);
  CHECK(contains(refused.errors, "letter.txt: cannot be made a folder: Not a directory"));
}

TEST_CASE("synth: negative disparities are possible, and how to match them is said") {
  const TemporaryFolder folder;
  const Outcome made = call(folder, "synth out --size 40x30 --disparities -9:6");
  CHECK(made.exit_code == 0);
  CHECK(contains(made.output, "run these scenes with --disparities -9:6"));
}

TEST_CASE("synth: mistakes are told in one line, before anything is written") {
  const TemporaryFolder folder;
  for (const auto& mistake : {std::pair{"synth out --size 64", "--size 64: write WIDTHxHEIGHT"},
                              {"synth out --size 0x5", "--size 0x5: write WIDTHxHEIGHT"},
                              {"synth out --size 999999x999999", "400 million"},
                              {"synth out --disparities 9:3", "did you mean 3:9?"},
                              {"synth out --fault blurr=2", "did you mean 'blur'?"},
                              {"synth out --fault noise=900", "give a number from 0 to 255"},
                              {"synth out --bits 12", "bits"},
                              {"synth out --count 0", "count"},
                              {"synth", "output"}}) {
    CAPTURE(mistake.first);
    const Outcome outcome = call(folder, mistake.first);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.errors, mistake.second));
  }
  CHECK_FALSE(std::filesystem::exists(folder / "out"));
  CHECK(call(folder, "synth /proc/nothing").exit_code == 2);
}
