// SPDX-License-Identifier: Apache-2.0
// Commands for tests of external stages.
#pragma once

#include <string>

#include "io/npy.hpp"
#include "support/paths.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/base/json.hpp"
#include "xgm/io/file.hpp"

namespace xgm::testing {

/// "command: [sh, ...]" that runs the script, which finds the folder of the request in $folder.
inline std::string command(const TemporaryFolder& desk, const std::string& script) {
  return "command: [sh, '" + desk.write("script.sh", "folder=$(dirname \"$1\")\n" + script + "\n") +
         "']";
}

/// The command of honest_program.
inline std::string honest(const std::string& task) {
  return "command: ['" XGM_BINARY_DIR "/bin/xgm_honest_program', " + task + "]";
}

/// Keeps what the program is given in desk/given, and answers with the file desk/NAME.
inline std::string keep_and_answer(const TemporaryFolder& desk, const std::string& name) {
  return command(desk, "rm -rf '" + (desk / "given") + "'; cp -r \"$folder\" '" + (desk / "given") +
                           "'; cp '" + (desk / name) + "' \"$folder\"");
}

inline Json request_in(const TemporaryFolder& desk) {
  return Json::parse(read_file(desk / "given/request.json"));
}

inline cv::Mat1f array_in(const std::string& file) {
  const NpyArray stored = read_npy(file);
  REQUIRE(stored.shape.size() == 2);
  cv::Mat1f values(static_cast<int>(stored.shape[0]), static_cast<int>(stored.shape[1]));
  std::size_t i = 0;
  for (float& value : values) value = static_cast<float>(stored.at(i++));
  return values;
}

}  // namespace xgm::testing
