// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

std::string float_bytes(std::initializer_list<float> values, bool big_endian) {
  std::string bytes;
  for (const float value : values) {
    char raw[4];
    std::memcpy(raw, &value, 4);
    if (big_endian != (std::endian::native == std::endian::big)) {
      std::swap(raw[0], raw[3]);
      std::swap(raw[1], raw[2]);
    }
    bytes.append(raw, 4);
  }
  return bytes;
}

}  // namespace

TEST_CASE("pfm: what is written is read again, bit by bit, none staying none") {
  const TemporaryFolder folder;
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(7, 5), cv::Size(1, 9), cv::Size(64, 1)}) {
    cv::Mat1f map(size);
    xgm::testing::Random random(3);
    for (float& value : map) value = static_cast<float>(random.real(-300, 300));
    map(size.height / 2, size.width / 2) = std::numeric_limits<float>::quiet_NaN();
    write_pfm(folder / "map.pfm", map);
    const cv::Mat1f read = read_pfm(folder / "map.pfm");
    REQUIRE(read.size() == size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        CHECK((std::isnan(map(y, x)) ? std::isnan(read(y, x)) : map(y, x) == read(y, x)));
      }
    }
  }
}

TEST_CASE("pfm: rows are bottom-up, both byte orders are read, the scale's size is ignored") {
  const TemporaryFolder folder;
  for (const bool big : {false, true}) {
    const std::string file = folder.write(
        "map.pfm", std::string("Pf\n2 2\n") + (big ? "0.003922\n" : "-0.003922\n") +
                       float_bytes({3, std::numeric_limits<float>::infinity(), 1, 2}, big));
    const cv::Mat1f map = read_pfm(file);
    CHECK(map(0, 0) == 1);
    CHECK(map(0, 1) == 2);
    CHECK(map(1, 0) == 3);
    CHECK(std::isnan(map(1, 1)));
  }
}

TEST_CASE("pfm: none is +inf on disk") {
  const TemporaryFolder folder;
  write_pfm(folder / "map.pfm", cv::Mat1f(1, 1, std::numeric_limits<float>::quiet_NaN()));
  const std::string bytes = read_file(folder / "map.pfm");
  CHECK(bytes.substr(bytes.size() - 4) == float_bytes({std::numeric_limits<float>::infinity()},
                                                      std::endian::native == std::endian::big));
}

TEST_CASE("pfm: pixels whose first byte looks like white space are not taken for the header") {
  const TemporaryFolder folder;
  const std::string pixel = "\n\n\n\n";
  const cv::Mat1f map = read_pfm(folder.write("map.pfm", "Pf 1 1 -1\n" + pixel));
  float expected = 0;
  std::memcpy(&expected, pixel.data(), 4);
  CHECK(map(0, 0) == expected);
}

TEST_CASE("pfm: blanks and either line end may stand behind the scale; pixels are never shifted") {
  const TemporaryFolder folder;
  for (const char* header : {"Pf\n2 1\n-1\n", "Pf\r\n2 1\r\n-1\r\n", "Pf\n2 1\n-1 \n", "Pf 2 1 -1 ",
                             "Pf\n2 1\n-1\t \r\n", "Pf\n2 1\n-1\r"}) {
    CAPTURE(header);
    for (const std::string pixels : {"\n\n\n\n\r\n \t", "\n\r\n ....", "abcdefgh"}) {
      const cv::Mat1f map = read_pfm(folder.write("map.pfm", header + pixels));
      CHECK(std::memcmp(map[0], pixels.data(), pixels.size()) == 0);
    }
  }
}

TEST_CASE("pfm: a file that is longer than its header says is refused") {
  const TemporaryFolder folder;
  const std::string pixels = "\n\n\n\n....";
  for (const std::string& bytes :
       {"Pf\n2 1\n-1\n" + pixels + "x", "Pf\n2 1\n-1\n" + pixels + "\n", "Pf\n2 1\n-1\n\n" + pixels,
        "Pf\n2 1\n-1\n\r\n" + pixels, "Pf\n2 1\n-1\n" + pixels + pixels,
        "PF\n2 1\n-1\n" + pixels + pixels + pixels + "    ",
        "Pf\r\n2 1\r\n-1\r\n" + std::string("\r\n\r\n\r\n\r\n....")}) {
    CAPTURE(bytes);
    const std::string file = folder.write("long.pfm", bytes);
    CHECK(contains(error_of([&] { read_pfm_planes(file); }),
                   file + ": is longer than its header says"));
  }
  const std::string file = folder.write("comment.pfm", "Pf\n# by hand\n2 1\n-1\n" + pixels);
  CHECK(contains(error_of([&] { read_pfm(file); }), "broken PFM header"));
}

TEST_CASE("pfm: colour planes come blue first") {
  const TemporaryFolder folder;
  const auto planes =
      read_pfm_planes(folder.write("c.pfm", "PF\n1 1\n-1\n" + float_bytes({1, 2, 3}, false)));
  REQUIRE(planes.size() == 3);
  CHECK(planes[0](0, 0) == 3);
  CHECK(planes[2](0, 0) == 1);
  CHECK(contains(error_of([&] { read_pfm(folder / "c.pfm"); }), "three channels"));
}

TEST_CASE("pfm: missing, empty, cut and junk files are errors that name the file") {
  const TemporaryFolder folder;
  write_pfm(folder / "good.pfm", cv::Mat1f(5, 4, 1.0f));
  const std::string good = read_file(folder / "good.pfm");
  for (std::size_t length = 0; length < good.size(); ++length) {
    const std::string file = folder.write("cut.pfm", good.substr(0, length));
    CHECK(contains(error_of([&] { read_pfm(file); }), file));
  }
  for (const char* junk :
       {"P5\n1 1\n255\nx", "Pf\n-1 4\n-1\n....", "Pf\n0 0\n-1\n", "Pf\n1 1\n0\n....",
        "Pf\n1 1\nnan\n....", "Pf\n99999999999999999999 1\n-1\n....",
        "Pf\n1048576 1048576\n-1\n....", "Pf\n2x 1\n-1\n........"}) {
    CAPTURE(junk);
    const std::string file = folder.write("junk.pfm", junk);
    CHECK(contains(error_of([&] { read_pfm(file); }), file));
  }
  CHECK(contains(error_of([&] { read_pfm(folder / "none.pfm"); }), "no such file"));
  CHECK(contains(error_of([&] { read_pfm(folder.path()); }), "is a folder"));
}
