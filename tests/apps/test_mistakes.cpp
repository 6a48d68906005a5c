// SPDX-License-Identifier: Apache-2.0
// Mistakes of users, and what the program makes of them.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>

#include "apps/program.hpp"
#include "support/paths.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::TemporaryFolder;

namespace {

const std::string kSevenFaults = R"(xgm: 1
matcher:
  type: pyramid
  search_range: {type: min_max, relaxation: four}
  matcher:
    type: left_right
    consistency: {type: lrrl, treshold: 1}
    matcher:
      type: semi_global
      cost: {type: census, window: 25}
      penalty: {type: constant, p1: 30, p2: 20}
      aggregation: {type: sgn, directions: 8}
      selection: wta
      filters: [zncc]
      selection: wta
)";

/// A pair whose left and right images are at hand, `disparity` apart.
struct Pair : TemporaryFolder {
  explicit Pair(int disparity) {
    const ImagePair pair = xgm::testing::shifted_pair({80, 24}, disparity, 5);
    write_png(*this / "left.png", picture(pair.base));
    write_png(*this / "right.png", picture(pair.match));
  }
  Outcome run(const std::string& arguments) const {
    return xgm::testing::pipeline(path(), "run sgm8 --disparities 0:31 " + arguments);
  }
};

const std::string kInOrder = "--left left.png --right right.png ";
const std::string kSwapped = "--left right.png --right left.png ";

Outcome call(const TemporaryFolder& folder, const std::string& arguments) {
  return xgm::testing::pipeline(folder.path(), arguments, "timeout 60 ");
}

}  // namespace

TEST_CASE("seven mistakes in a pipeline are seven located messages with remedies") {
  const TemporaryFolder folder;
  folder.write("p.yaml", kSevenFaults);
  // Opening a pipe that nobody writes to would never end: exit 2 shows that no image is opened.
  REQUIRE(::mkfifo((folder / "left.png").c_str(), 0600) == 0);
  REQUIRE(::mkfifo((folder / "right.png").c_str(), 0600) == 0);
  const Outcome outcome =
      call(folder, "run p.yaml --left left.png --right right.png --disparities 0:7");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 7);
  CHECK(contains(outcome.errors, "p.yaml:4:45: error: 'relaxation' must be a whole number"));
  CHECK(contains(outcome.errors, "p.yaml:7:31: error: lrrl has no parameter 'treshold'; did you"));
  CHECK(contains(outcome.errors, "p.yaml:10:36: error: 'window' cannot be 25; give an odd"));
  CHECK(contains(outcome.errors, "p.yaml:11:45: error: 'p2' of constant must not be below p1"));
  CHECK(contains(outcome.errors, "p.yaml:12:27: error: there is no aggregation called 'sgn'; did"));
  CHECK(contains(outcome.errors, "p.yaml:14:17: error: 'zncc' is a cost, not a filter; put a"));
  CHECK(contains(outcome.errors, "p.yaml:15:7: error: key 'selection' appears twice; keep one"));
  CHECK_FALSE(std::filesystem::exists(folder / "xgm_output"));
  const Outcome checked = call(folder, "check p.yaml");
  CHECK(checked.exit_code == 2);
  CHECK(checked.errors == outcome.errors);
}

TEST_CASE("swapped images are hinted at, images in order are not") {
  const Pair pair(9);
  const Outcome in_order = pair.run(kInOrder);
  CHECK(in_order.exit_code == 0);
  CHECK_FALSE(contains(in_order.errors, "swapped"));
  const Outcome swapped = pair.run(kSwapped);
  CHECK(swapped.exit_code == 0);
  CHECK(contains(swapped.errors, "are the images swapped?"));
}

TEST_CASE("a range that ends at the scene's disparity is hinted at") {
  const Pair pair(31);
  CHECK(contains(pair.run(kInOrder).errors, "lie at 31, where the search range 0 to 31 ends"));
}

TEST_CASE("a short range that misses the scene is hinted at, one that holds it is not") {
  const Pair pair(30);
  const std::string in_short = "run sgm8 --disparities 0:7 " + kInOrder;
  CHECK(contains(call(pair, in_short).errors, "where the search range 0 to 7 ends"));
  CHECK_FALSE(contains(call(Pair(3), in_short).errors, "where the search range"));
}

TEST_CASE("one image given twice is told, on the terminal and in run.json") {
  const Pair pair(9);
  std::filesystem::create_symlink(pair / "left.png", pair / "link.png");
  for (const char* right : {"left.png", "link.png"}) {
    const Outcome outcome = pair.run(std::string("--left left.png --right ") + right);
    CHECK(outcome.exit_code == 0);
    CHECK(contains(outcome.errors, "the left and the right image are the same"));
    CHECK(contains(read_file(pair / "xgm_output/run.json"), "the left and the right image are"));
  }
  CHECK_FALSE(contains(pair.run(kInOrder).errors, "image are the same"));
}

TEST_CASE("a pattern of --dump that fits no stage is warned of") {
  const Pair pair(9);
  CHECK(contains(pair.run(kInOrder + "--dump nothing").errors, "--dump nothing: no stage"));
  CHECK_FALSE(contains(pair.run(kInOrder + "--dump '*cost'").errors, "no stage"));
}

TEST_CASE("a pipeline file without end is read no further than 16 MB") {
  const TemporaryFolder folder;
  const Outcome outcome = call(folder, "check /dev/zero");
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.errors, "larger than 16 MB"));
}

TEST_CASE("names that no file can have are mistakes of usage") {
  const TemporaryFolder folder;
  const std::string endless(5000, 'a');
  for (const std::string& arguments : {"check " + endless, "run sgm8 " + endless}) {
    const Outcome outcome = call(folder, arguments);
    CHECK(outcome.exit_code == 2);
    CHECK_FALSE(contains(outcome.errors, "filesystem"));
  }
  CHECK(call(folder, "--version; XGM_PLUGIN_PATH=" + endless + " timeout 60 '" +
                         XGM_PIPELINE_BINARY "' list")
            .exit_code == 0);
}

TEST_CASE("a pipeline file beside the one that is not there is suggested") {
  const TemporaryFolder folder;
  folder.write("mine.yaml", "xgm: 1\nmatcher: opencv_sgbm\n");
  for (const char* name : {"mine.yml", "MINE.yaml", "./mien.yaml", "mine"}) {
    CAPTURE(name);
    const Outcome outcome = call(folder, std::string("check ") + name);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.errors, "did you mean 'mine.yaml'?"));
  }
}

TEST_CASE("what the parser of the command line refuses is an error like others") {
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> mistakes[] = {
      {"run", "error: pipeline is required; see pipeline run --help"},
      {"run sgm8 --left /dev/null", "error: --left requires --right; see pipeline run --help"},
      {"run sgm8 . --threads 0", "error: --threads: Value 0 not in range 1 to 1024; see"}};
  for (const auto& mistake : mistakes) {
    const Outcome outcome = call(folder, mistake.first);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.errors, mistake.second));
  }
}

TEST_CASE("an unknown subcommand is named") {
  const TemporaryFolder folder;
  const Outcome outcome = call(folder, "rnu sgm8");
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.errors, "there is no subcommand 'rnu'; did you mean 'run'?"));
}

TEST_CASE("an unknown option is named, and not what follows from it") {
  const TemporaryFolder folder;
  const Outcome outcome = call(folder, "bench --piplines sgm8");
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.errors, "there is no option '--piplines'; did you mean '--pipelines'?"));
}

TEST_CASE("short options that do not exist, and long ones with one dash, are named") {
  const TemporaryFolder folder;
  const Outcome unknown = call(folder, "run sgm8 -x 3");
  CHECK(unknown.exit_code == 2);
  CHECK(contains(unknown.errors, "there is no option '-x'"));
  const Outcome one_dash = call(folder, "run sgm8 -disparities 0:15");
  CHECK(one_dash.exit_code == 2);
  CHECK(contains(one_dash.errors, "did you mean '--disparities'?"));
  const Outcome early = call(folder, "--disparities 0:15 run sgm8");
  CHECK(early.exit_code == 2);
  CHECK(contains(early.errors, "the subcommand comes first"));
}

TEST_CASE("images without option names: the message names --left and --right") {
  const Pair pair(9);
  for (const char* command :
       {"run sgm8 left.png right.png", "plan sgm8 left.png right.png", "run sgm8 left.png",
        "run left.png right.png", "speed sgm8 left.png right.png",
        "explain sgm8 left.png right.png 3 4"}) {
    CAPTURE(command);
    const Outcome outcome = call(pair, command);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.errors, "--left"));
  }
  const Outcome judged = call(pair, "eval left.png right.png");
  CHECK(judged.exit_code == 2);
  CHECK(contains(judged.errors, "--truth"));
}

TEST_CASE("output that cannot be written to stdout is a failure") {
  const TemporaryFolder folder;
  for (const char* arguments : {"list", "schema", "graph sgm8", "--help"}) {
    CAPTURE(arguments);
    CHECK(call(folder, std::string(arguments) + " > /dev/full").exit_code == 1);
  }
}

TEST_CASE("an output folder that cannot be written to is found out before matching") {
  const Pair pair(9);
  const Outcome outcome = pair.run(kInOrder + "--output /proc");
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.errors, "--output /proc"));
}

TEST_CASE("a path of --set deeper than any pipeline ends at once, in one line") {
  const TemporaryFolder folder;
  std::string path = "a";
  for (int i = 0; i < 20000; ++i) path += ".a";
  const Outcome deep = call(folder, "check sgm8 --set " + path + "=1");
  CHECK(deep.exit_code == 2);
  CHECK(contains(deep.errors, "not a path"));
  const Outcome broken = call(folder, "check sgm8 --set 'a\nb=1'");
  CHECK(broken.exit_code == 2);
  CHECK(std::count(broken.errors.begin(), broken.errors.end(), '\n') == 1);
}
