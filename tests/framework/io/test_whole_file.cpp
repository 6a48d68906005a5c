// SPDX-License-Identifier: Apache-2.0
// Files that are shorter or longer than they say.
#include <doctest/doctest.h>

#include <opencv2/imgcodecs.hpp>

#include "io/unscaled_image.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "support/tiff_file.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::Random;
using xgm::testing::TemporaryFolder;

namespace {

/// Smooth enough for lossy formats, and with so much in it that files have several thousand bytes.
cv::Mat3b picture() {
  cv::Mat3b image(61, 83);
  Random random(5);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const auto level = [&](int slope) {
        return static_cast<uchar>(slope + random.integer(0, 29));
      };
      image(y, x) = cv::Vec3b(level(2 * x), level(3 * y), level(x + y));
    }
  }
  return image;
}

std::string encoded(const std::string& ending, const cv::Mat& image,
                    const std::vector<int>& parameters = {}) {
  std::vector<uchar> bytes;
  REQUIRE(cv::imencode(ending, image, bytes, parameters));
  return {bytes.begin(), bytes.end()};
}

/// The message of reading these bytes as an image; empty if they are read.
std::string refusal(const TemporaryFolder& folder, const std::string& bytes,
                    const std::string& name = "image") {
  const std::string file = folder.write(name, bytes);
  const std::string message = error_of([&] { read_unscaled(file); });
  if (!message.empty()) CHECK(contains(message, file + ": "));
  return message;
}

}  // namespace

TEST_CASE("images of every format that are cut are refused: at a third, two thirds, by one byte") {
  const TemporaryFolder folder;
  const cv::Mat3b colour = picture();
  cv::Mat1b grey;
  cv::extractChannel(colour, grey, 1);
  cv::Mat3f floats;
  colour.convertTo(floats, CV_32F);
  xgm::testing::write_tiff(folder / "tiled.tif", {grey}, {.tiled = true});
  const std::vector<std::pair<std::string, std::string>> files{
      {"JPEG", encoded(".jpg", colour)},
      {"progressive JPEG", encoded(".jpg", colour, {cv::IMWRITE_JPEG_PROGRESSIVE, 1})},
      {"JPEG with restarts", encoded(".jpg", colour, {cv::IMWRITE_JPEG_RST_INTERVAL, 2})},
      {"grey JPEG", encoded(".jpg", grey)},
      {"PNG", encoded(".png", colour)},
      {"TIFF", encoded(".tif", colour)},
      {"raw TIFF", encoded(".tif", colour, {cv::IMWRITE_TIFF_COMPRESSION, 1})},
      {"tiled TIFF", read_file(folder / "tiled.tif")},
      {"float TIFF", encoded(".tif", floats)},
      {"BMP", encoded(".bmp", colour)},
      {"WebP", encoded(".webp", colour)},
      {"JPEG 2000", encoded(".jp2", colour)},
      {"PPM", encoded(".ppm", colour)},
      {"PGM", encoded(".pgm", grey)},
      {"PBM", encoded(".pbm", grey)},
      {"PAM", encoded(".pam", colour)},
      {"Sun raster", encoded(".ras", colour)},
      {"Radiance", encoded(".hdr", floats)},
      {"EXR", encoded(".exr", floats)},
      {"PFM", encoded(".pfm", floats)},
  };
  for (const auto& file : files) {
    const std::string &format = file.first, &bytes = file.second;
    CAPTURE(format);
    CHECK(refusal(folder, bytes).empty());
    for (const std::size_t length : {bytes.size() / 3, 2 * bytes.size() / 3, bytes.size() - 1}) {
      CAPTURE(length);
      CHECK_FALSE(refusal(folder, bytes.substr(0, length)).empty());
    }
  }
}

TEST_CASE("a JPEG may be followed by anything, as cameras append previews; so may a PNG") {
  const TemporaryFolder folder;
  for (const char* ending : {".jpg", ".png"}) {
    const std::string bytes = encoded(ending, picture());
    CHECK(refusal(folder, bytes + std::string(1000, '\0')).empty());
    CHECK(refusal(folder, bytes + bytes).empty());
  }
}

TEST_CASE("a JPEG with damaged data is refused, wherever the damage is") {
  const TemporaryFolder folder;
  const std::string good = encoded(".jpg", picture());
  const std::size_t scan = good.find("\xff\xda") + 14;  // where the data begin
  Random random(11);
  int refused = 0;
  constexpr int kTrials = 40;
  for (int i = 0; i < kTrials; ++i) {
    std::string bytes = good;
    const auto room = static_cast<int>(bytes.size() - scan - 70);
    const std::size_t at = scan + static_cast<std::size_t>(random.integer(0, room));
    for (std::size_t k = at; k < at + 64; ++k) bytes[k] = static_cast<char>(random.integer(0, 255));
    if (!refusal(folder, bytes).empty()) ++refused;
  }
  // Random bits are now and then a code of the same length: no decoder can see those.
  CHECK(refused >= kTrials - 2);
}

TEST_CASE("PNM: bytes behind the pixels are refused, as what the header says is not there") {
  const TemporaryFolder folder;
  const std::string pixels = "abcdef";
  CHECK(refusal(folder, "P5 3 2 255\n" + pixels).empty());
  CHECK(refusal(folder, "P5\n# a comment\n3 2\n255\n" + pixels).empty());
  CHECK(refusal(folder, "P5\n3 2\n65535\n" + pixels + pixels).empty());
  CHECK(refusal(folder, "P2\n3 2\n255\n1 2 3\n4 5 6\n").empty());
  CHECK(refusal(folder, "P1\n3 2\n101\n010\n").empty());
  for (const char* header : {"P5\r\n3 2\r\n255\r\n", "P5\n3 2\n255 \n", "P5\n3 2\n255\n\n",
                             "P5\n3 1\n255\n", "P5\n1 1\n65535\n", "P6\n1 1\n255\n"}) {
    CAPTURE(header);
    CHECK(contains(refusal(folder, header + pixels), "is longer than its header says"));
  }
  CHECK(contains(refusal(folder, "P5\n3 2\n65535\n" + pixels), "is cut short: 19 of 25 bytes"));
  CHECK(contains(refusal(folder, "P2\n3 2\n255\n1 2 3 4 5 6 7"), "holds 7 numbers"));
  CHECK(contains(refusal(folder, "P2\n3 2\n255\n1 2 3 4 5"), "holds 5 numbers"));
  CHECK(contains(refusal(folder, "P3\n1 1\n255\n1 2"), "its header says 3"));
  for (const char* header : {"P5\n", "P5\n3\n", "P5\n3 -2\n255\n", "P5\n3 2\n0\n",
                             "P5\n3 2\n70000\n", "P5\n99999999 99999999\n255\n", "P7\nWIDTH 3\n"}) {
    CAPTURE(header);
    CHECK(contains(refusal(folder, header), "has a broken header"));
  }
}

TEST_CASE("a file of no known format is refused, whatever decoder OpenCV may guess for it") {
  const TemporaryFolder folder;
  // Some build of OpenCV hands this to GDAL, one of whose drivers takes it for 300 MB of pixels.
  const std::string guessed =
      "//)]\x0b\xc2\x0bMA\x0b\xb8\x0b\xb8\x0b\xb2\x0b\xb8\x0bO\xb8]\x0b\xc2\x0bMAXVAL"
      "\x0b\xb8\x0b\xb8WWWWWWW\x0b";
  for (const std::string& bytes : {guessed, std::string("no image"), std::string("P")}) {
    CHECK(contains(refusal(folder, bytes), "is no image that can be read"));
  }
}

TEST_CASE("a header that states more pixels than its file can hold is refused, of every format") {
  const TemporaryFolder folder;
  const cv::Mat3b colour = picture();
  cv::Mat3f floats;
  colour.convertTo(floats, CV_32F);
  struct Large {
    std::string format, bytes;
    std::size_t at;     // of the sides
    std::string sides;  // about 1e9 pixels and more
  };
  const std::string jp2 = encoded(".jp2", colour), hdr = encoded(".hdr", floats),
                    exr = encoded(".exr", floats);
  const std::string wide("\0\0\x7f\xff\0\0\x7f\xff", 8), wide_little("\xff\x7f\0\0\xff\x7f\0\0", 8);
  const std::vector<Large> files{
      {"PNG", encoded(".png", colour), 16, wide},
      {"BMP", encoded(".bmp", colour), 18, wide_little},
      {"WebP, lossy", encoded(".webp", colour, {cv::IMWRITE_WEBP_QUALITY, 50}), 26,
       "\xff\x3f\xff\x3f"},
      {"WebP, lossless", encoded(".webp", colour, {cv::IMWRITE_WEBP_QUALITY, 101}), 21,
       "\xff\xff\xff\x0f"},
      {"JPEG 2000", jp2, jp2.find("\xff\x4f\xff\x51") + 8, wide},
      {"JPEG 2000, alone", jp2.substr(jp2.find("\xff\x4f\xff\x51")), 8, wide},
      {"Sun raster", encoded(".ras", colour), 4, wide},
      {"Radiance", hdr, hdr.find("-Y "), "-Y 60000 +X 60000\n"},
      {"EXR", exr, exr.find("dataWindow") + 29, wide_little},
  };
  for (const Large& file : files) {
    CAPTURE(file.format);
    std::string bytes = file.bytes;
    bytes.replace(file.at, file.sides.size(), file.sides);
    CHECK(contains(refusal(folder, bytes), "has a broken header: it speaks of "));
  }
}
