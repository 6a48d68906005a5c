// SPDX-License-Identifier: Apache-2.0
// Commands behind the figures that no test can run (they take minutes, or programs that are built
// on request) are at least ones that exist.
#include <doctest/doctest.h>

#include <regex>
#include <sstream>

#include "apps/program.hpp"
#include "docs/blocks.hpp"
#include "support/paths.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

using Words = std::vector<std::string>;

/// The commands of unchecked shell blocks.
std::vector<Words> unchecked_commands(const std::string& file) {
  std::vector<Words> commands;
  for (const Block& block : code_blocks(file)) {
    if (block.language != "sh" || block.details != Words{"unchecked"}) continue;
    std::istringstream lines(block.text);
    for (std::string line; std::getline(lines, line);) {
      Words& words = commands.emplace_back();
      std::istringstream stream(line);
      for (std::string word; stream >> word;) words.push_back(word);
    }
  }
  return commands;
}

/// Options that are spelt out, and the subcommand.
void check_pipeline_call(const Words& words) {
  const TemporaryFolder folder;
  const Outcome help = pipeline(folder.path(), words.at(1) + " --help");
  CHECK(help.exit_code == 0);
  for (const std::string& word : words) {
    if (!word.starts_with("--")) continue;
    CAPTURE(word);
    CHECK(contains(help.output, word.substr(0, word.find('='))));
  }
}

/// A program of tests/bench. Names of benchmarks begin with a group that its sources name.
void check_bench_call(const std::string& program, const Words& words) {
  CHECK(contains(source_text("tests/bench/CMakeLists.txt"), program + " "));
  std::string sources;
  for (const char* file : {"roofline/paths.cpp", "roofline/hamming.cpp", "roofline/memory.cpp",
                           "stages/volumes.cpp", "stages/maps.cpp"}) {
    sources += source_text(std::string("tests/bench/") + file);
  }
  static const std::regex filter("--benchmark_filter=([a-z_]+/).*");
  for (const std::string& word : words) {
    std::smatch match;
    if (!std::regex_match(word, match, filter)) continue;
    CAPTURE(word);
    CHECK(contains(sources, "\"" + match[1].str()));
  }
}

void check_cmake_call(const Words& words) {
  const std::string lists = source_text("CMakeLists.txt") + source_text("CMakePresets.json") +
                            source_text("tests/bench/CMakeLists.txt");
  static const std::regex named("-D([A-Z_]+)=.*|(xgm_[a-z_]+)|(release)");
  for (const std::string& word : words) {
    std::smatch match;
    if (!std::regex_match(word, match, named)) continue;
    CAPTURE(word);
    CHECK(contains(lists, match[1].str() + match[2].str() + match[3].str()));
  }
}

void check_command(Words words) {
  static const std::regex assignment("XGM_SIMD=(scalar|sse4|avx2|avx512|avx512_dl)");
  if (std::regex_match(words.front(), assignment)) words.erase(words.begin());
  const std::string program = words.front().substr(words.front().rfind('/') + 1);
  if (program == "pipeline") {
    check_pipeline_call(words);
  } else if (program.starts_with("xgm_bench_")) {
    check_bench_call(program, words);
  } else if (program == "cmake") {
    check_cmake_call(words);
  } else {
    CHECK_MESSAGE(program == "cmp", "nothing says how to check this command");
  }
}

}  // namespace

TEST_CASE("the commands behind the figures exist") {
  for (const std::string file : {"docs/performance.md", "tests/bench/README.md"}) {
    const std::vector<Words> commands = unchecked_commands(file);
    CHECK(commands.size() > 3);
    for (const Words& words : commands) {
      std::string line;
      for (const std::string& word : words) line += word + ' ';
      CAPTURE(line);
      check_command(words);
    }
  }
}

TEST_CASE("the pipeline that races OpenCV is sgm8 cut down to one view") {
  const auto load = [](const std::string& file) {
    const LoadedPipeline loaded =
        load_pipeline(std::string(XGM_SOURCE_DIR) + "/" + file, builtins());
    REQUIRE(loaded.pipeline);
    return loaded.pipeline->graph();
  };
  const std::string whole = load("pipelines/sgm8.yaml");
  std::istringstream lines(load("tests/bench/sgm8_one_view.yaml"));
  int shared = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string stage = line.substr(std::min(line.find_first_not_of(' '), line.size()));
    for (const char* slot : {"cost:", "penalty:", "aggregation:", "selection:"}) {
      if (!stage.starts_with(slot)) continue;
      CHECK_MESSAGE(contains(whole, stage), stage);
      ++shared;
    }
  }
  CHECK(shared == 4);
}
