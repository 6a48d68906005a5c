// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>
#include <sys/wait.h>

#include <atomic>
#include <csignal>
#include <thread>

#include "support/temporary_folder.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/output_folder.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

TEST_CASE("FolderLock: one at a time, by whatever path, and nothing is left") {
  const TemporaryFolder folder;
  {
    const FolderLock first(folder.path());
    const std::string message = error_of([&] { const FolderLock second(folder / "."); });
    CHECK(contains(message, "another run or bench writes to " + (folder / ".")));
    const TemporaryFolder other;
    CHECK_NOTHROW(FolderLock(other.path()));
  }
  CHECK_NOTHROW(FolderLock(folder.path()));
  CHECK(folder.files() == 0);
}

TEST_CASE("FolderLock: it ends with its process, even if that is killed") {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const FolderLock lock(folder.path());
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(WIFSIGNALED(status));
  CHECK_NOTHROW(FolderLock(folder.path()));
}

TEST_CASE("make_output_folder: makes folders in folders, and leaves no trace of its trial") {
  const TemporaryFolder folder;
  make_output_folder(folder / "a/b/c", "--output ");
  CHECK(std::filesystem::is_empty(folder / "a/b/c"));
  folder.write("file", "");
  CHECK(contains(error_of([&] { make_output_folder(folder / "file", "--output "); }),
                 "--output " + (folder / "file") + ": cannot be made a folder"));
  CHECK(contains(error_of([&] { require_writable("/proc", "--json "); }), "--json /proc"));
}

TEST_CASE("OutputFolder: what it made and nothing came into does not stay, all else does") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "there");
  for (const char* name : {"a/b/c", "a/b/c/", "there/d", "there"}) {
    CAPTURE(name);
    {
      const OutputFolder made(folder / name);
      CHECK(std::filesystem::is_directory(folder / name));
    }
    CHECK_FALSE(std::filesystem::exists(folder / "a"));
    CHECK(std::filesystem::is_empty(folder / "there"));
  }
  {
    const OutputFolder made(folder / "a/b/c");
    folder.write("a/mine", "");
  }
  CHECK(std::filesystem::exists(folder / "a/mine"));
  CHECK_FALSE(std::filesystem::exists(folder / "a/b"));
}

TEST_CASE("OutputFolder: one that is refused takes nothing away from the one that has it") {
  const TemporaryFolder folder;
  const OutputFolder first(folder / "a/b");
  const std::string message = error_of([&] { const OutputFolder second(folder / "a/b"); });
  CHECK(contains(message, "another run or bench writes to "));
  CHECK(std::filesystem::is_directory(folder / "a/b"));
}

TEST_CASE("OutputFolder: a folder that is made and taken away by many at once is never lost") {
  const TemporaryFolder folder;
  std::atomic<int> lost = 0;
  const auto work = [&] {
    for (int round = 0; round < 300; ++round) {
      try {
        const OutputFolder mine(folder / "a");
        if (!std::filesystem::is_directory(folder / "a")) ++lost;
      } catch (const UsageError&) {  // another one has it, or takes it away just now
      }
    }
  };
  { const std::jthread one(work), two(work), three(work); }
  CHECK(lost == 0);
}
