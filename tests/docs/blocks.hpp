// SPDX-License-Identifier: Apache-2.0
// Fenced code blocks of Markdown files.
#pragma once

#include <string>
#include <vector>

namespace xgm::testing {

struct Block {
  std::string place;                 ///< "docs/write_a_plugin.md:12"
  std::string language;              ///< first word after the fence
  std::vector<std::string> details;  ///< the words after it
  std::string text;                  ///< the lines inside, each with its line end
};

/// The blocks of a file, named relative to the source tree. Throws Error if it cannot be read or a
/// fence stays open.
std::vector<Block> code_blocks(const std::string& file);

/// README.md, CONTRIBUTING.md and all Markdown files below docs/, relative to the source tree.
std::vector<std::string> documents();

/// The content of a file of the source tree.
std::string source_text(const std::string& file);

}  // namespace xgm::testing
