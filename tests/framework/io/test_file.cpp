// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <ostream>

#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

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

TEST_CASE("read_file: longer than the limit is an error") {
  const TemporaryFolder folder;
  const std::string file = folder.write("long", "12345");
  CHECK(read_file(file, 5) == "12345");
  CHECK(contains(error_of([&] { read_file(file, 4); }), "larger than 4 bytes"));
}
