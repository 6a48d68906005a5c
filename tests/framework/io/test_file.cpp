// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <ostream>

#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace fs = std::filesystem;

namespace {

/// Whether a file of this folder can be without a name. Elsewhere, what is killed leaves a part.
bool has_nameless_files(const std::string& folder) {
  const int file = ::open(folder.c_str(), O_TMPFILE | O_WRONLY, 0600);
  return file >= 0 && ::close(file) == 0;
}

/// What the body returns in a process of its own, whose limits are nobody else's.
std::string in_child(const std::function<std::string()>& body) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const std::string text = body();
    const bool told = ::write(ends[1], text.data(), text.size()) >= 0;
    ::_exit(told ? 0 : 1);
  }
  ::close(ends[1]);
  std::string text(1000, '\0');
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::read(ends[0], text.data(), 1000))));
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return text;
}

}  // namespace

TEST_CASE("write_file: a write that fails leaves the old file and nothing else") {
  const TemporaryFolder folder;
  write_file(folder / "a.txt", "old");
  const auto half = [](std::ostream& stream) {
    stream << "ne";
    throw Error("no more");
  };
  CHECK(error_of([&] { write_file(folder / "a.txt", half); }) == "no more");
  CHECK(read_file(folder / "a.txt") == "old");
  CHECK(folder.files() == 1);
  write_file(folder / "a.txt", "new");
  CHECK(read_file(folder / "a.txt") == "new");
  CHECK(folder.files() == 1);
}

TEST_CASE("write_file: a full disk and a missing folder are errors") {
  const TemporaryFolder folder;
  const std::string lost = folder / "no/such/folder/a.txt";
  CHECK(contains(error_of([&] { write_file(lost, "x"); }), lost + ": cannot be written"));
  std::filesystem::create_directory(folder / "taken");
  std::filesystem::create_directory(folder / "taken/inside");
  CHECK(contains(error_of([&] { write_file(folder / "taken", "x"); }), "cannot be written"));
  CHECK(folder.files() == 1);
}

TEST_CASE("write_file: a device or a pipe stays what it is, and a link to a file is replaced") {
  const TemporaryFolder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  fs::create_symlink("/dev/null", folder / "null");
  for (const char* name : {"pipe", "null"}) {
    CHECK(contains(error_of([&] { write_file(folder / name, "x"); }), "a device or a pipe"));
    CHECK_FALSE(fs::is_regular_file(fs::status(folder / name)));
  }
  folder.write("target", "mine");
  fs::create_symlink("target", folder / "link");
  write_file(folder / "link", "new");
  CHECK(read_file(folder / "link") == "new");
  CHECK(read_file(folder / "target") == "mine");
}

TEST_CASE("write_file: a process that is killed while it writes leaves nothing") {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  for (const char* name : {"a.txt", "b.txt"}) {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      write_file(folder / name, [](std::ostream& stream) {
        stream << "half" << std::flush;
        ::kill(::getpid(), SIGKILL);
      });
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE(WIFSIGNALED(status));
  }
  CHECK(read_file(folder / "a.txt") == "old");
  if (has_nameless_files(folder.path())) CHECK(folder.files() == 1);
}

TEST_CASE("write_file: a file that outgrows what is allowed is one error, and nothing is left") {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  const std::string message = in_child([&] {
    const rlimit small{.rlim_cur = 1000, .rlim_max = RLIM_INFINITY};
    ::setrlimit(RLIMIT_FSIZE, &small);
    ::signal(SIGXFSZ, SIG_IGN);
    return error_of([&] { write_file(folder / "a.txt", std::string(5000, 'x')); });
  });
  CHECK(contains(message, "a.txt: cannot be written: File too large"));
  CHECK(read_file(folder / "a.txt") == "old");
  CHECK(folder.files() == 1);
}

TEST_CASE("fnv1a64 gives its authors' test values") {
  CHECK(fnv1a64("") == 0xcbf29ce484222325u);
  CHECK(fnv1a64("a") == 0xaf63dc4c8601ec8cu);
  CHECK(fnv1a64("foobar") == 0x85944171f73967e8u);
}

TEST_CASE("identify_file: size and hash of files longer than one piece") {
  const TemporaryFolder folder;
  const std::string text(3'000'001, 'x');
  const FileIdentity identity = identify_file(folder.write("long", text));
  CHECK(identity.bytes == text.size());
  char expected[17];
  std::snprintf(expected, sizeof expected, "%016llx",
                static_cast<unsigned long long>(fnv1a64(text)));
  CHECK(identity.fnv1a64 == expected);
}

TEST_CASE("is_still: an old time and the size are enough, else the hash decides") {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const std::string file = folder.write("a.txt", "one");
  CHECK(identify_file(file).modified == 0);  // a change within the same tick would not show
  CHECK(is_still(file, identify_file(file)));
  const auto old = fs::last_write_time(file) - std::chrono::minutes(1);
  fs::last_write_time(file, old);
  const FileIdentity identity = identify_file(file);
  CHECK(identity.modified != 0);
  CHECK(is_still(file, identity));
  fs::last_write_time(file, old + std::chrono::seconds(3));
  CHECK(is_still(file, identity));  // touched, the same content
  folder.write("a.txt", "two");
  CHECK_FALSE(is_still(file, identity));
  fs::last_write_time(file, old);
  CHECK(is_still(file, identity));  // what no hash is made for cannot be seen
  folder.write("a.txt", "three");
  fs::last_write_time(file, old);
  CHECK_FALSE(is_still(file, identity));
  fs::remove(file);
  CHECK(contains(error_of([&] { is_still(file, identity); }), "a.txt: no such file"));
}

TEST_CASE("read_file: longer than the limit is an error") {
  const TemporaryFolder folder;
  const std::string file = folder.write("long", "12345");
  CHECK(read_file(file, 5) == "12345");
  CHECK(contains(error_of([&] { read_file(file, 4); }), "larger than 4 bytes"));
}
