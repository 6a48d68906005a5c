// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Writes both images and reads them as a pair.
ReadPair pair_of(const TemporaryFolder& folder, const cv::Mat& left, const cv::Mat& right,
                 const std::string& ending = ".png") {
  cv::imwrite(folder / ("left" + ending), left);
  cv::imwrite(folder / ("right" + ending), right);
  return read_pair({folder / ("left" + ending), folder / ("right" + ending), "", ""});
}

ReadPair float_pair(const TemporaryFolder& folder, const cv::Mat1f& left, const cv::Mat1f& right) {
  write_pfm(folder / "left.pfm", left);
  write_pfm(folder / "right.pfm", right);
  return read_pair({folder / "left.pfm", folder / "right.pfm", "", ""});
}

}  // namespace

TEST_CASE("8-bit images keep their values, grey and colour, in every lossless format") {
  const TemporaryFolder folder;
  cv::Mat1b grey(3, 5);
  cv::Mat3b colour(3, 5);
  for (int i = 0; i < 15; ++i) {
    grey(i) = static_cast<uchar>(17 * i);
    colour(i) = cv::Vec3b(static_cast<uchar>(i), static_cast<uchar>(100 + i), 255);
  }
  for (const char* ending : {".png", ".tif", ".pgm", ".bmp"}) {
    CAPTURE(ending);
    const ReadPair read = pair_of(folder, grey, grey, ending);
    REQUIRE(read.pair.base.planes.size() == 1);
    for (int i = 0; i < 15; ++i) CHECK(read.pair.base.planes[0](i) == static_cast<float>(grey(i)));
    CHECK(read.pair.base.valid.empty());
    CHECK(read.notes.empty());
  }
  for (const char* ending : {".png", ".tif", ".ppm", ".bmp"}) {
    CAPTURE(ending);
    const ReadPair read = pair_of(folder, colour, colour, ending);
    REQUIRE(read.pair.match.planes.size() == 3);
    for (int i = 0; i < 15; ++i) {
      for (int c = 0; c < 3; ++c) {
        CHECK(read.pair.match.planes[static_cast<std::size_t>(c)](i) ==
              static_cast<float>(colour(i)[c]));
      }
    }
  }
}

TEST_CASE("16-bit images: 65535 is white, or the largest value's bits up to 12, for both alike") {
  const TemporaryFolder folder;
  const auto first = [&](ushort left, ushort right) {
    const ReadPair read = pair_of(folder, cv::Mat1w(2, 2, left), cv::Mat1w(2, 2, right));
    return std::pair(read.pair.base.planes[0](0), read.pair.match.planes[0](0));
  };
  CHECK(first(65535, 0).first == doctest::Approx(255));
  CHECK(first(4096, 1).first == doctest::Approx(4096 * 255.0 / 65535));
  CHECK(first(4095, 1).first == doctest::Approx(255));
  CHECK(first(100, 2047).first == doctest::Approx(100 * 255.0 / 2047));
  CHECK(first(100, 2047).second == doctest::Approx(255));
  CHECK(first(100, 1024).first == doctest::Approx(100 * 255.0 / 2047));
  CHECK(first(100, 255).first == doctest::Approx(100));  // 8-bit data in a 16-bit file
  CHECK(first(3, 2).first == doctest::Approx(3));        // a dark image is not made bright
  CHECK(first(0, 0).first == 0);
}

TEST_CASE("float images: 0..1, 0..255 and any other range") {
  const TemporaryFolder folder;
  const cv::Mat1f unit = (cv::Mat1f(1, 3) << 0, 0.5f, 1);
  CHECK(float_pair(folder, unit, unit).pair.base.planes[0](1) == doctest::Approx(127.5));
  const cv::Mat1f levels = (cv::Mat1f(1, 3) << 0, 1.5f, 254);
  CHECK(float_pair(folder, levels, unit).pair.base.planes[0](1) == 1.5f);
  CHECK(float_pair(folder, levels, unit).pair.match.planes[0](1) == 0.5f);
  const cv::Mat1f low = (cv::Mat1f(1, 3) << -100, 0, 100);
  const cv::Mat1f high = (cv::Mat1f(1, 3) << 0, 300, 200);
  const ReadPair read = float_pair(folder, low, high);
  CHECK(read.pair.base.planes[0](0) == doctest::Approx(0));
  CHECK(read.pair.base.planes[0](1) == doctest::Approx(255 * 100 / 400.0));
  CHECK(read.pair.match.planes[0](1) == doctest::Approx(255));
  const cv::Mat1f flat(1, 3, 1000.0f);
  CHECK(float_pair(folder, flat, flat).pair.base.planes[0](0) == 0);
}

TEST_CASE("NaN and infinite pixels are masked, and do not take part in the scale") {
  const TemporaryFolder folder;
  const cv::Mat1f left = (cv::Mat1f(1, 3) << kNan, 0.5f, 1);
  const cv::Mat1f right = (cv::Mat1f(1, 3) << 0, std::numeric_limits<float>::infinity(), 1);
  const ImagePair pair = float_pair(folder, left, right).pair;
  CHECK_FALSE(pair.base.is_valid(0, 0));
  CHECK(pair.base.is_valid(0, 1));
  CHECK_FALSE(pair.match.is_valid(0, 1));
  CHECK(pair.base.planes[0](0) == 0);
  CHECK(pair.base.planes[0](1) == doctest::Approx(127.5));
  const cv::Mat1f none(1, 3, kNan);
  CHECK(cv::countNonZero(float_pair(folder, none, none).pair.base.valid) == 0);
}

TEST_CASE("alpha masks where it is 0, unless it is 0 everywhere") {
  const TemporaryFolder folder;
  cv::Mat4b image(2, 2, cv::Vec4b(10, 20, 30, 255));
  image(0, 1)[3] = 0;
  image(1, 0)[3] = 1;
  const ImagePair pair = pair_of(folder, image, cv::Mat4b(2, 2, cv::Vec4b(10, 20, 30, 0))).pair;
  REQUIRE(pair.base.planes.size() == 3);
  CHECK(pair.base.planes[2](0, 0) == 30);
  CHECK_FALSE(pair.base.is_valid(0, 1));
  CHECK(pair.base.is_valid(1, 0));
  CHECK(pair.match.valid.empty());
}

TEST_CASE("a grey and a colour image are both made grey") {
  const TemporaryFolder folder;
  const ReadPair read = pair_of(folder, cv::Mat1b(2, 3, 7), cv::Mat3b(2, 3, cv::Vec3b(10, 20, 30)));
  REQUIRE(read.pair.match.planes.size() == 1);
  CHECK(read.pair.match.planes[0](0) == doctest::Approx(0.114 * 10 + 0.587 * 20 + 0.299 * 30));
  CHECK(read.pair.base.planes[0](0) == 7);
  CHECK(read.notes.size() == 1);
}

TEST_CASE("masks: non-zero may be used; they keep outliers out of the scale") {
  const TemporaryFolder folder;
  write_pfm(folder / "left.pfm", (cv::Mat1f(1, 3) << -9999, 0.5f, 1));
  write_pfm(folder / "right.pfm", (cv::Mat1f(1, 3) << 0, 0.5f, 1));
  write_png(folder / "mask.png", cv::Mat1b((cv::Mat1b(1, 3) << 0, 1, 255)));
  const ImagePair pair =
      read_pair({folder / "left.pfm", folder / "right.pfm", folder / "mask.png", ""}).pair;
  CHECK_FALSE(pair.base.is_valid(0, 0));
  CHECK(pair.base.is_valid(0, 1));
  CHECK(pair.base.planes[0](1) == doctest::Approx(127.5));
  CHECK(pair.match.valid.empty());
  write_png(folder / "wide.png", cv::Mat1b(1, 4, 255));
  CHECK(contains(error_of([&] {
                   read_pair({folder / "left.pfm", folder / "right.pfm", "", folder / "wide.png"});
                 }),
                 "wide.png: is 4 x 1 pixels"));
}

TEST_CASE("images in memory are scaled as files of them are") {
  const TemporaryFolder folder;
  cv::Mat1w deep(3, 5);
  for (int i = 0; i < 15; ++i) deep(i) = static_cast<ushort>(4000 * i);
  cv::Mat4b colour(3, 5);
  for (int i = 0; i < 15; ++i) {
    const auto level = static_cast<uchar>(i);
    colour(i) = cv::Vec4b(level, static_cast<uchar>(100 + i), 255, i == 7 ? uchar{0} : uchar{255});
  }
  for (const cv::Mat& image : {cv::Mat(deep), cv::Mat(colour)}) {
    const ReadPair of_files = pair_of(folder, image, image);
    const ReadPair in_memory = to_pair(to_unscaled("left", image), to_unscaled("right", image));
    CHECK(have_same_pixels(in_memory.pair.base, of_files.pair.base));
    const cv::Mat1b &valid = in_memory.pair.base.valid, &valid_of_file = of_files.pair.base.valid;
    CHECK(valid.empty() == valid_of_file.empty());
    if (!valid.empty()) CHECK(cv::countNonZero(valid != valid_of_file) == 0);
    CHECK(in_memory.notes == of_files.notes);
  }
}

TEST_CASE("grey float images in memory: shared if nothing changes, and never written to") {
  const cv::Mat1f levels = (cv::Mat1f(1, 4) << 0, 3, 200, 255);
  const cv::Mat1f unit = (cv::Mat1f(1, 4) << 0, 0.25F, 0.5F, 1);
  const cv::Mat1f holes = (cv::Mat1f(1, 4) << 0, kNan, 200, 255);
  for (const cv::Mat1f& image : {levels, unit, holes}) {
    const cv::Mat1f before = image.clone();
    const ReadPair read = to_pair(to_unscaled("left", image), to_unscaled("right", image));
    const cv::Mat1f& plane = read.pair.base.planes[0];
    CHECK((plane.data == image.data) == (image.data == levels.data));
    CHECK(have_same_pixels(Image(image), Image(before)));
    CHECK(plane(1) == (image.data == unit.data ? 63.75F : image.data == holes.data ? 0 : 3));
  }
}

TEST_CASE("pairs that do not fit and files that are no images are errors that name the file") {
  const TemporaryFolder folder;
  CHECK(contains(error_of([&] { pair_of(folder, cv::Mat1b(2, 3, 0.0), cv::Mat1b(2, 4, 0.0)); }),
                 "right.png: is 4 x 2 pixels but " + folder / "left.png" + " is 3 x 2"));
  CHECK(contains(error_of([&] { pair_of(folder, cv::Mat1b(2, 3, 0.0), cv::Mat1w(2, 3, 0.0)); }),
                 "right.png: is 16-bit but"));
  for (const char* junk : {"", "x", "\x89PNG\r\n\x1a\n", "P5\n9999 9999\n255\nabc", "Pf\n"}) {
    CAPTURE(junk);
    const std::string file = folder.write("junk.png", junk);
    CHECK(contains(error_of([&] { read_pair({file, file, "", ""}); }), file + ": "));
  }
  const std::string missing = folder / "missing.png";
  CHECK(contains(error_of([&] { read_pair({missing, missing, "", ""}); }), "no such file"));
}

TEST_CASE("true disparities: PFM as they are, PNG by the divisor with 0 for none") {
  const TemporaryFolder folder;
  cv::imwrite(folder / "kitti.png", cv::Mat1w((cv::Mat1w(1, 2) << 0, 640)));
  const cv::Mat1f kitti = read_disparities(folder / "kitti.png", 256).value;
  CHECK(std::isnan(kitti(0)));
  CHECK(kitti(1) == 2.5f);
  write_pfm(folder / "t.pfm", (cv::Mat1f(1, 3) << kNan, -3.5f, 0));
  const cv::Mat1f map = read_disparities(folder / "t.pfm").value;
  CHECK(std::isnan(map(0)));
  CHECK(map(1) == -3.5f);
  CHECK(map(2) == 0);
  CHECK(contains(error_of([&] { read_disparities(folder / "t.pfm", 0); }), "divisor"));
}

TEST_CASE("disparities: a negative divisor turns the signs, and grey may be stored as colour") {
  const TemporaryFolder folder;
  const cv::Mat3b grey = (cv::Mat3b(1, 2) << cv::Vec3b(40, 40, 40), cv::Vec3b(0, 0, 0));
  cv::imwrite(folder / "grey.png", grey);
  const cv::Mat1f map = read_disparities(folder / "grey.png", -4).value;
  CHECK(map(0) == -10);
  CHECK(std::isnan(map(1)));
  const DisparityMap read = read_map(folder / "grey.png", 4).value;
  CHECK(read.at(0, 0) == Status::matched);
  CHECK(read.at(0, 1) == Status::out_of_range);
}

TEST_CASE("disparities: pictures of them are refused, and why") {
  const TemporaryFolder folder;
  const auto refusal = [&](const cv::Mat& image, std::optional<double> divisor) {
    cv::imwrite(folder / "picture.png", image);
    return error_of([&] { read_disparities(folder / "picture.png", divisor); });
  };
  const cv::Mat3b colour = (cv::Mat3b(1, 2) << cv::Vec3b(40, 40, 41), cv::Vec3b(0, 0, 0));
  CHECK(contains(refusal(colour, {}), "colour picture"));
  CHECK(contains(refusal(colour, 4), "colour picture"));
  CHECK(contains(refusal(cv::Mat1b(1, 2, 9), {}), "whole numbers (8-bit)"));
  CHECK(contains(refusal(cv::Mat1w(1, 2, 900), {}), "whole numbers (16-bit)"));
  CHECK(refusal(cv::Mat1b(1, 2, 9), 1).empty());
}
