// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/ply.hpp"

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

const PlyHeader kAllTypes{.comments = {"made by a test", "crs EPSG:32740"},
                          .properties = {{"a", PlyType::int8},
                                         {"b", PlyType::uint8},
                                         {"c", PlyType::int16},
                                         {"d", PlyType::uint16},
                                         {"e", PlyType::int32},
                                         {"f", PlyType::uint32},
                                         {"g", PlyType::float32},
                                         {"h", PlyType::float64}},
                          .count = 2};
using Values = std::array<double, 8>;

std::string little_endian(const std::string& vertices, const std::string& body,
                          const std::string& rest = {}) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + vertices +
         "\nproperty uchar a\nproperty short b\n" + rest + "end_header\n" + body;
}

std::vector<std::array<double, 2>> read_two(const std::string& file) {
  PlyReader reader(file);
  std::vector<std::array<double, 2>> all;
  for (std::array<double, 2> values{}; reader.next(values);) all.push_back(values);
  return all;
}

}  // namespace

TEST_CASE("a PLY that is written is read as it was, every type with its ends") {
  const TemporaryFolder folder;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Values low{-128, 0, -32768, 0, -2147483648.0, 0, -0.1F, 7651922.7721182145};
  const Values high{127, 255, 32767, 65535, 2147483647.0, 4294967295.0, 1e30F, nan};
  write_ply(folder / "all.ply", kAllTypes, [&](const PutVertex& put) {
    put(low);
    put(high);
  });
  PlyReader reader(folder / "all.ply");
  CHECK(reader.header().comments == kAllTypes.comments);
  CHECK(reader.header().count == 2);
  REQUIRE(reader.header().properties.size() == 8);
  CHECK(reader.header().properties[3].name == "d");
  CHECK(reader.header().properties[3].type == PlyType::uint16);
  Values read{};
  REQUIRE(reader.next(read));
  CHECK(read == low);
  REQUIRE(reader.next(read));
  CHECK(std::isnan(read[7]));
  read[7] = 0;
  Values expected = high;
  expected[7] = 0;
  CHECK(read == expected);
  CHECK_FALSE(reader.next(read));
}

TEST_CASE("whole numbers of a PLY are rounded and stay within their type") {
  const TemporaryFolder folder;
  PlyHeader header = kAllTypes;
  header.count = 1;
  write_ply(folder / "w.ply", header, [](const PutVertex& put) {
    put(Values{-1e9, 300, 1.6, NAN, 1e12, -4, 0, 0});
  });
  PlyReader reader(folder / "w.ply");
  Values read{};
  REQUIRE(reader.next(read));
  CHECK(read == Values{-128, 255, 2, 0, 2147483647.0, 0, 0, 0});
}

TEST_CASE("a PLY is written with the vertices that it announces, or not at all") {
  const TemporaryFolder folder;
  const auto write_one = [&] {
    write_ply(folder / "w.ply", kAllTypes, [](const PutVertex& put) { put(Values{}); });
  };
  CHECK(contains(error_of(write_one), "2 points were announced, but 1 written"));
  CHECK(folder.files() == 0);
}

TEST_CASE("bytes of a PLY by hand, with faces behind, and the same as text") {
  const TemporaryFolder folder;
  using namespace std::string_literals;
  const std::string body = "\x07\xfe\xff\x08\x00\x01"s;  // 7, -2 and 8, 256
  write_file(folder / "b.ply", little_endian("2",
                                             body + "\x03"
                                                    "abc",
                                             "element face 1\nproperty list uchar int i\n"));
  write_file(folder / "a.ply",
             "ply\r\nformat ascii 1.0\r\nobj_info x\r\nelement vertex 2\r\nproperty uint8 a\r\n"
             "property int16 b\r\nend_header\r\n7 -2\r\n8 256\r\n");
  for (const char* name : {"b.ply", "a.ply"}) {
    CAPTURE(name);
    const auto points = read_two(folder / name);
    REQUIRE(points.size() == 2);
    CHECK(points[0] == std::array<double, 2>{7, -2});
    CHECK(points[1] == std::array<double, 2>{8, 256});
  }
}

TEST_CASE("what is no PLY, or not whole, is refused by name and place") {
  const TemporaryFolder folder;
  const std::string file = folder / "x.ply";
  const auto why = [&](const std::string& bytes) {
    write_file(file, bytes);
    const std::string error = error_of([&] { read_two(file); });
    CHECK(error.starts_with(file));
    return error;
  };
  const std::string head = "ply\nformat binary_little_endian 1.0\n";
  CHECK(contains(why("solid cube"), "is no PLY file"));
  CHECK(contains(why(head), "does not end"));
  CHECK(contains(why(little_endian("2", "12345")), "announces 2 points, but at most 1 are there"));
  CHECK(contains(why(little_endian("18446744073709551615", "")), "at most 0"));
  CHECK(contains(why(little_endian("-1", "")), ":3: '-1' is no number of elements"));
  CHECK(contains(why("ply\nformat binary_big_endian 1.0\nelement vertex 0\nend_header\n"),
                 ":2: format binary_big_endian is not read"));
  CHECK(contains(why(head + "element face 0\nelement vertex 0\nend_header\n"),
                 "vertices must come first"));
  CHECK(contains(why(little_endian("0", "", "property list uchar int c\n")), ":6: "));
  CHECK(contains(why(little_endian("0", "", "property half c\n")), "'half' is no type"));
  CHECK(contains(why(little_endian("0", "", "property int a\n")), "another property 'a'"));
  CHECK(contains(why(little_endian("0", "", "nonsense\n")), ":6: this line"));
  CHECK(contains(why("ply\nelement vertex 0\nproperty int a\nend_header\n"), "no format"));
  CHECK(contains(why(head + "end_header\n"), "nothing of vertices"));
  CHECK(contains(why(head + "element vertex 0\nend_header\n"), "no properties"));
  const std::string text = "ply\nformat ascii 1.0\nelement vertex 2\nproperty int a\n";
  CHECK(contains(why(text + "property int b\nend_header\n1 2 3 four"), "point 2: 'four' is no"));
  CHECK(contains(why(text + "property int b\nend_header\n1 2 3     "), "point 2: is missing"));
  CHECK(contains(why(text + "property int b\nend_header\n1 2"), "at most 1 are there"));
  CHECK(contains(error_of([&] { PlyReader(folder / "none.ply"); }), "no such file"));
}
