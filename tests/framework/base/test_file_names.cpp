// SPDX-License-Identifier: Apache-2.0
// Names of files in any case of letters.
#include <doctest/doctest.h>

#include "support/temporary_folder.hpp"
#include "xgm/base/file_names.hpp"

using namespace xgm;
using xgm::testing::TemporaryFolder;

TEST_CASE("lower_case changes ASCII letters only") {
  CHECK(lower_case("Im0.PNG_\xC3\x84") == "im0.png_\xC3\x84");
  CHECK(lower_case("") == "");
}

TEST_CASE("find_name: the exact name, else the only other one") {
  CHECK(find_name({"a.PNG", "a.png"}, "a.png") == "a.png");
  CHECK(find_name({"a.PNG", "b.png"}, "a.png") == "a.PNG");
  CHECK(find_name({"a.PNG", "A.png"}, "a.png") == "");
  CHECK(find_name({"b.png"}, "a.png") == "");
}

TEST_CASE("find_path: each part that is not there as written; unchanged if nothing is found") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "Left/B");
  folder.write("Left/B/x.PNG", "1");
  CHECK(find_path(folder / "left/b/X.png") == folder / "Left/B/x.PNG");
  CHECK(find_path(folder / "Left/B/x.PNG") == folder / "Left/B/x.PNG");
  CHECK(find_path(folder / "left/c/x.png") == folder / "left/c/x.png");
  folder.write("Left/B/X.PNG", "2");
  CHECK(find_path(folder / "left/b/x.png") == folder / "left/b/x.png");
  CHECK(find_path("") == "");
  CHECK(find_path("no such file") == "no such file");
}
