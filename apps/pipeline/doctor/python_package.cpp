// SPDX-License-Identifier: Apache-2.0
#include "doctor/python_package.hpp"

#include <array>
#include <cstdio>

#include "xgm/plugin/version.hpp"

namespace xgm::cli {
namespace {

/// The first line that a shell command prints; "" if it fails.
std::string first_line_of(const char* command) {
  FILE* const pipe = ::popen(command, "r");
  if (pipe == nullptr) return {};
  std::array<char, 4096> line{};
  const bool read = std::fgets(line.data(), static_cast<int>(line.size()), pipe) != nullptr;
  if (::pclose(pipe) != 0 || !read) return {};
  const std::string text = line.data();
  return text.substr(0, text.find('\n'));
}

}  // namespace

Finding python_package() {
  const std::string found = first_line_of(
      "python3 -c 'import xgm; print(xgm.__version__, xgm.__file__)' 2>/dev/null </dev/null");
  Finding finding{.topic = "python"};
  const std::string version = found.substr(0, found.find(' '));
  if (found.empty()) {
    finding.health = Health::missing;
    finding.text =
        "python3 finds no package xgm; docs/python.md says how to install it, or how to set "
        "PYTHONPATH to a build";
  } else if (version != XGM_VERSION) {
    finding.health = Health::broken;
    finding.text = "python3 finds xgm " + found +
                   ", but this is xgm " XGM_VERSION "; install the package of this version";
  } else {
    finding.text = "python3 finds xgm " + found;
    finding.facts = {{"version", version}, {"file", found.substr(version.size() + 1)}};
  }
  return finding;
}

}  // namespace xgm::cli
