// SPDX-License-Identifier: Apache-2.0
// Every code block of README, CONTRIBUTING and docs/ is true. What stands after the fence's
// language says how:
//   yaml FILE.yaml         a sound pipeline; later blocks of the same page find it under that name
//   yaml faulty FILE.yaml  the same, but it is for later blocks to say what is wrong
//   yaml KIND              one stage of that kind
//   cpp FILE, cmake FILE   taken from FILE of a project in tests/out_of_tree that is built and run:
//                          project (plugins) or programs
//   sh [exit=N]            calls of `pipeline`, run in a folder with images, exit code N (0)
//   text                   after sh: all that the last call printed
//   python                 run by tests/python/test_guide.py
//   ... unchecked          anything else
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

#include "apps/program.hpp"
#include "docs/blocks.hpp"
#include "support/paths.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"
#include "xgm/testing/synthetic.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

// What the guides call "your own images": a small pair with masks, truth and range maps, once as
// files and once as a scene folder, a folder of two scenes with cameras; what stands for the pairs
// of docs/performance.md; and in build/ the plugins of the example project.
void write_inputs(const TemporaryFolder& folder) {
  const SyntheticScene scene = make_scene({});
  const cv::Mat1b everywhere(scene.pair.size(), 255);
  for (const char* sub_folder : {"scene", "samples/field", "samples/house"}) {
    std::filesystem::create_directories(folder / sub_folder);
  }
  for (const std::string name :
       {"left.png", "scene/im0.png", "samples/field/im0.png", "samples/house/im0.png"}) {
    write_png(folder / name, picture(scene.pair.base));
  }
  for (const std::string name :
       {"right.png", "scene/im1.png", "samples/field/im1.png", "samples/house/im1.png"}) {
    write_png(folder / name, picture(scene.pair.match));
  }
  for (const std::string name : {"left_mask.png", "right_mask.png"}) {
    write_png(folder / name, everywhere);
  }
  folder.write("scene/calib.txt", "ndisp=32\n");
  for (const std::string name : {"samples/field/calib.txt", "samples/house/calib.txt"}) {
    folder.write(name, "cam0=[200 0 80; 0 200 60; 0 0 1]\ndoffs=4\nbaseline=120\nndisp=32\n");
  }
  write_pfm(folder / "scene/disp0GT.pfm", scene.truth);
  write_png(folder / "scene/mask0nocc.png", scene.non_occluded);
  write_pfm(folder / "truth.pfm", scene.truth);
  write_pfm(folder / "min.pfm", cv::Mat1f(scene.truth - 4));
  write_pfm(folder / "max.pfm", cv::Mat1f(scene.truth + 4));
  std::filesystem::create_directory_symlink(folder / "scene", folder / "motorcycle");
  std::filesystem::create_directory_symlink(XGM_SOURCE_DIR "/tests", folder / "tests");
  std::filesystem::create_directories(folder / "build/aloe");
  std::filesystem::copy(folder / "left.png", folder / "build/aloe/aloeL.jpg");
  std::filesystem::copy(folder / "right.png", folder / "build/aloe/aloeR.jpg");
  for (const auto& entry : std::filesystem::directory_iterator(XGM_EXAMPLE_PLUGINS)) {
    const std::string name = "build/" + entry.path().filename().string();
    std::filesystem::create_symlink(entry.path(), folder / name);
  }
}

Registry registry_with_examples() {
  Registry registry = Registry::with_builtins();
  registry.load_path(XGM_EXAMPLE_PLUGINS);
  return registry;
}

// The arguments of a call of `pipeline`, wherever the page has it; nothing if it is another
// program.
std::optional<std::string> arguments_of(const std::string& command) {
  static const std::regex call(R"((?:\S*/)?pipeline (.*))");
  std::smatch match;
  if (!std::regex_match(command, match, call)) return std::nullopt;
  return match[1];
}

class Page {
 public:
  explicit Page(std::string file) : file_(std::move(file)) { write_inputs(folder_); }

  void check() {
    for (const Block& block : code_blocks(file_)) {
      CAPTURE(block.place);
      check(block);
      after_shell_ = block.language == "sh" && !says(block, "unchecked");
    }
  }

 private:
  static bool says(const Block& block, const std::string& word) {
    return std::find(block.details.begin(), block.details.end(), word) != block.details.end();
  }

  void check(const Block& block) {
    if (says(block, "unchecked")) return;
    if (block.language == "python") return;  // tests/python/test_guide.py
    const std::string detail = block.details.empty() ? "" : block.details.back();
    if (block.language == "yaml" && detail.ends_with(".yaml")) {
      folder_.write(detail, block.text);
      if (!says(block, "faulty")) check_pipeline(block.text, detail);
    } else if (block.language == "yaml" && !detail.empty()) {
      CHECK_NOTHROW(make_stage(detail, block.text, registry_));
    } else if ((block.language == "cpp" || block.language == "cmake") && !detail.empty()) {
      CHECK(is_of_project(detail, block.text));
    } else if (block.language == "sh") {
      run(block, detail.starts_with("exit=") ? std::stoi(detail.substr(5)) : 0);
    } else if (block.language == "text" && after_shell_) {
      CHECK(printed_ == block.text);
    } else {
      FAIL_CHECK("nothing says how to check this block; see the top of test_guides.cpp");
    }
  }

  static bool is_of_project(const std::string& name, const std::string& text) {
    const std::filesystem::path projects =
        std::filesystem::path(XGM_SOURCE_DIR) / "tests/out_of_tree";
    for (const char* project : {"project", "programs"}) {
      const std::string file = (projects / project / name).string();
      if (std::filesystem::exists(file) && contains(read_file(file), text)) return true;
    }
    return false;
  }

  void check_pipeline(const std::string& text, const std::string& name) {
    const LoadedPipeline loaded = load_pipeline_text(text, name, registry_);
    for (const Diagnostic& diagnostic : loaded.diagnostics) FAIL_CHECK(to_string(diagnostic));
  }

  void run(const Block& block, int exit_code) {
    static const std::regex continuation(R"(\\\n\s*)");
    std::istringstream lines(std::regex_replace(block.text, continuation, ""));
    for (std::string line; std::getline(lines, line);) {
      CAPTURE(line);
      const auto arguments = arguments_of(line);
      if (!arguments) {
        FAIL_CHECK("not a call of pipeline");
        continue;
      }
      const Outcome outcome = pipeline(folder_.path(), *arguments);
      CAPTURE(outcome.errors);
      CHECK(outcome.exit_code == exit_code);
      printed_ = outcome.output + outcome.errors;
    }
  }

  std::string file_;
  TemporaryFolder folder_;
  Registry registry_ = registry_with_examples();
  std::string printed_;
  bool after_shell_ = false;
};

}  // namespace

TEST_CASE("every code block of the documents is true") {
  for (const std::string& file : documents()) {
    SUBCASE(file.c_str()) { Page(file).check(); }
  }
}

TEST_CASE("every link of the documents to a file of the tree leads somewhere") {
  static const std::regex link(R"(\]\(([^)#:\s]+)(#[^)]*)?\))");
  for (const std::string& file : documents()) {
    const std::string text = source_text(file);
    const std::filesystem::path folder =
        (std::filesystem::path(XGM_SOURCE_DIR) / file).parent_path();
    for (std::sregex_iterator i(text.begin(), text.end(), link), end; i != end; ++i) {
      CHECK_MESSAGE(std::filesystem::exists(folder / (*i)[1].str()), file, " -> ", (*i)[1].str());
    }
  }
}

TEST_CASE("README's table and the shipped pipelines are the same") {
  const std::string readme = source_text("README.md");
  const auto folder = std::filesystem::path(XGM_SOURCE_DIR) / "pipelines";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const std::string row = "| `" + entry.path().stem().string() + "` |";
    CHECK_MESSAGE(contains(readme, row), row);
  }
}

TEST_CASE("every plugin's texts are whole sentences") {
  for (const PluginInfo* plugin : builtins().plugins()) {
    CHECK_MESSAGE(plugin->summary.ends_with('.'), plugin->name);
    const auto prototype = plugin->prototype();
    for (const Field& field : prototype->parameters().fields()) {
      CHECK_MESSAGE(field.text.ends_with('.'), plugin->name, ": ", field.name);
      CHECK_FALSE_MESSAGE(field.text.ends_with(".."), plugin->name, ": ", field.name);
    }
  }
}
