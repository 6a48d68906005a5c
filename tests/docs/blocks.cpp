// SPDX-License-Identifier: Apache-2.0
#include "docs/blocks.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "support/paths.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"

namespace xgm::testing {
namespace fs = std::filesystem;

std::string source_text(const std::string& file) {
  return read_file((fs::path(XGM_SOURCE_DIR) / file).string());
}

std::vector<Block> code_blocks(const std::string& file) {
  std::vector<Block> blocks;
  std::istringstream lines(source_text(file));
  std::string line;
  bool inside = false;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (!line.starts_with("```")) {
      if (inside) blocks.back().text += line + '\n';
      continue;
    }
    inside = !inside;
    if (!inside) continue;
    Block block;
    block.place = file + ":" + std::to_string(number);
    std::istringstream words(line.substr(3));
    words >> block.language;
    for (std::string word; words >> word;) block.details.push_back(word);
    blocks.push_back(std::move(block));
  }
  if (inside) throw Error(blocks.back().place + ": this block has no end; add ```");
  return blocks;
}

std::vector<std::string> documents() {
  std::vector<std::string> files{"README.md", "CONTRIBUTING.md"};
  const fs::path source(XGM_SOURCE_DIR);
  for (const auto& entry : fs::recursive_directory_iterator(source / "docs")) {
    if (entry.path().extension() == ".md") {
      files.push_back(entry.path().lexically_relative(source).string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace xgm::testing
