// SPDX-License-Identifier: Apache-2.0
#include "apps/small_disk.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <iostream>

#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"

namespace xgm::testing {

bool goes_on_after_full_disk(const std::string& folder, const std::string& size,
                             const ResumedRun& run) {
  const Outcome outcome =
      run("unshare -rm sh -c 'mkdir -p out && mount -t tmpfs -o size=" + size +
          " tmpfs out || exit 99; "
          "\"$@\" 2> full.txt; echo full: $?; ls -A out; mount -o remount,size=64m out; "
          "\"$@\"; echo room: $?; cp -r out saved' sh ");
  const std::string written = folder + "/full.txt";
  if (!std::filesystem::exists(written)) {
    std::cout << "SKIPPED: a full disk needs a file system that this user may mount" << std::endl;
    return false;
  }
  const std::string errors = read_file(written);
  INFO(errors);
  INFO(outcome.output);
  CHECK(contains(errors, "cannot be written: No space left on device"));
  CHECK(errors.find("error:") == errors.rfind("error:"));
  CHECK(contains(outcome.output, "full: 1\nunfinished.xgm\n"));
  CHECK(contains(outcome.output, "room: 0"));
  return true;
}

}  // namespace xgm::testing
