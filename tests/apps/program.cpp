// SPDX-License-Identifier: Apache-2.0
#include "apps/program.hpp"
#include "support/paths.hpp"

#include <doctest/doctest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace xgm::testing {

Outcome pipeline(const std::string& folder, const std::string& arguments,
                 const std::string& before) {
  const std::string errors = folder + "/stderr.txt";
  const std::string command = "cd '" + folder + "' && " + before + "'" XGM_PIPELINE_BINARY "' " +
                              arguments + " 2> '" + errors + "' < /dev/null";
  Outcome outcome;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> buffer;
  std::size_t count = 0;
  while ((count = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0) {
    outcome.output.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  std::ifstream stream(errors);
  outcome.errors.assign(std::istreambuf_iterator<char>(stream), {});
  return outcome;
}

void check_usage_error(const Outcome& outcome, const std::string& message) {
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.errors.find(message) != std::string::npos);
}

}  // namespace xgm::testing
