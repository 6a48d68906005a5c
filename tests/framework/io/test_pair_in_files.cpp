// SPDX-License-Identifier: Apache-2.0
// Windows of image files beside the whole images.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <opencv2/imgcodecs.hpp>

#include "support/png_file.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "support/tiff_file.hpp"
#include "xgm/data/crop.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/pair_in_files.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::Random;
using xgm::testing::TemporaryFolder;
using xgm::testing::TiffStyle;
using xgm::testing::write_png_as;
using xgm::testing::write_tiff;

namespace {

const cv::Size kSize(53, 41);  // no multiple of a tile or strip

cv::Mat noise(cv::Size size, int type, double low, double high, std::uint64_t seed) {
  cv::Mat image(size, type);
  cv::RNG random(seed);
  random.fill(image, cv::RNG::UNIFORM, low, high);
  return image;
}

std::vector<cv::Mat> bands_of(int depth, int count, double low, double high, std::uint64_t seed) {
  std::vector<cv::Mat> bands;
  cv::split(noise(kSize, CV_MAKETYPE(depth, count), low, high, seed), bands);
  return bands;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  if (a.empty() || b.empty()) return a.empty() == b.empty();
  for (int y = 0; y < a.rows; ++y) {
    if (std::memcmp(a.ptr(y), b.ptr(y), static_cast<std::size_t>(a.cols) * a.elemSize()) != 0) {
      return false;
    }
  }
  return a.size() == b.size();
}

bool same(const Image& a, const Image& b) {
  return same(a.valid, b.valid) &&
         std::equal(a.planes.begin(), a.planes.end(), b.planes.begin(), b.planes.end(),
                    [](const cv::Mat1f& p, const cv::Mat1f& q) { return same(p, q); });
}

/// The whole reader and the windows say the same, in pixels, notes and warnings; windows that know
/// what others have looked for have the same pixels.
void check_windows(const PairFiles& files, const TemporaryFolder& folder) {
  const ReadPair whole = read_pair(files);
  const std::size_t held = folder.files();
  const PairInFiles windows(files, folder.path());
  CHECK(folder.files() == held);
  CHECK(windows.size() == whole.pair.size());
  CHECK(windows.notes() == whole.notes);
  CHECK(windows.warnings() == whole.warnings);
  const PairInFiles told(files, folder.path(), windows.look());
  CHECK(told.notes().empty());
  CHECK(told.warnings().empty());
  for (const bool of_match : {false, true}) {
    CHECK(told.masked_share(of_match) == windows.masked_share(of_match));
  }
  Random random(7);
  for (int k = 0; k < 12; ++k) {
    const cv::Size size = windows.size();
    const int x = random.integer(0, size.width - 1), y = random.integer(0, size.height - 1);
    const cv::Rect window(x, y, random.integer(1, size.width - x),
                          random.integer(1, size.height - y));
    const cv::Rect read = k == 0 ? cv::Rect({}, size) : window;
    const ImagePair expected = crop(whole.pair, read);
    for (const PairInFiles* reader : {&windows, &told}) {
      const ImagePair part = reader->read(read);
      CHECK(same(part.base, expected.base));
      CHECK(same(part.match, expected.match));
    }
  }
}

void check_tiffs(const TemporaryFolder& folder, int depth, int count, double low, double high,
                 const TiffStyle& style) {
  const PairFiles files{.left = folder / "left.tif", .right = folder / "right.tif"};
  write_tiff(files.left, bands_of(depth, count, low, high, 1), style);
  write_tiff(files.right, bands_of(depth, count, low, high, 2), style);
  check_windows(files, folder);
}

}  // namespace

TEST_CASE("windows of TIFFs are those of the whole image, for every layout, depth and codec") {
  const TemporaryFolder folder;
  struct Values {
    int depth;
    double low, high;
  };
  const Values all[] = {{CV_8U, 0, 256},   {CV_16U, 0, 65536}, {CV_16U, 0, 1000},
                        {CV_16S, -99, 99}, {CV_32F, 0, 1},     {CV_32F, -40, 900}};
  for (const Values& values : all) {
    for (const int count : {1, 3, 4}) {
      for (int style = 0; style < 16; ++style) {
        CAPTURE(values.depth);
        CAPTURE(count);
        CAPTURE(style);
        check_tiffs(folder, values.depth, count, values.low, values.high,
                    {.bands_apart = (style & 1) != 0,
                     .tiled = (style & 2) != 0,
                     .compressed = (style & 4) != 0,
                     .big = (style & 8) != 0,
                     .has_alpha = count == 4});
      }
    }
  }
}

TEST_CASE("windows of TIFFs that are turned, or that OpenCV decodes, are those of the whole") {
  const TemporaryFolder folder;
  for (int orientation = 1; orientation <= 8; ++orientation) {
    CAPTURE(orientation);
    check_tiffs(folder, CV_8U, 3, 0, 256, {.tiled = true, .orientation = orientation});
  }
  check_tiffs(folder, CV_8U, 1, 0, 256, {.white_is_zero = true});
}

TEST_CASE("windows know what means no data in all of the file: tag, option, mask, alpha, marks") {
  const TemporaryFolder folder;
  check_tiffs(folder, CV_8U, 1, 0, 6, {.no_data = "3", .tiled = true});
  check_tiffs(folder, CV_16U, 3, 0, 2, {.no_data = "0"});
  PairFiles files{.left = folder / "left.tif", .right = folder / "right.tif", .no_data = {2, 5}};
  check_windows(files, folder);
  const auto write_pair = [&](const std::vector<cv::Mat>& bands, const TiffStyle& style = {}) {
    write_tiff(files.left, bands, style);
    write_tiff(files.right, bands_of(bands.front().depth(), 1, 0, 50, 4), {});
  };
  // A mark, one that is too large, NaN and infinity, in a few pixels of one corner.
  std::vector<cv::Mat> marked = bands_of(CV_32F, 1, 0, 50, 3);
  marked[0](cv::Rect(40, 30, 4, 3)).setTo(-9999);
  marked[0](cv::Rect(44, 30, 2, 3)).setTo(-77777777);
  marked[0].at<float>(0, 0) = 3e38F;
  marked[0].at<float>(0, 9) = NAN;
  marked[0].at<float>(5, 9) = INFINITY;
  write_pair(marked);
  check_windows(files, folder);
  // Alpha that was filled in at one pixel only, and not at all.
  std::vector<cv::Mat> with_alpha = bands_of(CV_8U, 2, 0, 50, 3);
  with_alpha[1].setTo(0);
  write_pair(with_alpha, {.has_alpha = true});
  check_windows(files, folder);
  with_alpha[1].at<uchar>(40, 50) = 9;
  write_pair(with_alpha, {.has_alpha = true});
  check_windows(files, folder);
  // Masks, of zeros and ones, too.
  files.left_mask = folder / "mask.png";
  write_png(files.left_mask, cv::Mat1b(noise(kSize, CV_8U, 0, 2, 8)));
  check_windows(files, folder);
  files.right_mask = folder / "mask.tif";
  write_tiff(files.right_mask, bands_of(CV_16U, 1, 0, 2, 9), {.tiled = true});
  check_windows(files, folder);
  write_png(files.right_mask = folder / "all.png", cv::Mat1b(kSize, 255));
  check_windows(files, folder);
}

TEST_CASE("windows of PNGs are those of the whole image, for every kind there is") {
  const TemporaryFolder folder;
  const PairFiles files{.left = folder / "left.png", .right = folder / "right.png"};
  for (const int depth : {CV_8U, CV_16U}) {
    for (const auto& kind : {std::pair(0, 1), {2, 3}, {3, 1}, {4, 2}, {6, 4}}) {
      const int colour_type = kind.first, bands = kind.second;
      for (int style = 0; style < 4; ++style) {
        if (depth == CV_16U && colour_type == 3) continue;
        if (style >= 2 && colour_type != 0 && colour_type != 2) continue;
        CAPTURE(depth);
        CAPTURE(colour_type);
        CAPTURE(style);
        const int type = CV_MAKETYPE(depth, bands);
        const testing::PngStyle png{colour_type, (style & 1) != 0, style >= 2};
        write_png_as(files.left, noise(kSize, type, 0, 65536, 1), png);
        write_png_as(files.right, noise(kSize, type, 0, 65536, 2), png);
        check_windows(files, folder);
      }
    }
  }
}

TEST_CASE("windows of other formats, and of a grey and a colour image, are those of the whole") {
  const TemporaryFolder folder;
  for (const std::string ending : {".jpg", ".bmp", ".pgm", ".pfm"}) {
    CAPTURE(ending);
    const PairFiles files{.left = folder / ("left" + ending), .right = folder / ("right" + ending)};
    for (const auto& [file, seed] : {std::pair(files.left, 1U), {files.right, 2U}}) {
      const cv::Mat image = noise(kSize, ending == ".pfm" ? CV_32F : CV_8U, 0, 256, seed);
      if (ending == ".pfm") {
        write_pfm(file, cv::Mat1f(image));
      } else {
        REQUIRE(cv::imwrite(file, image));
      }
    }
    check_windows(files, folder);
    CHECK(PairInFiles(files, folder.path()).held_bytes() > 0);
  }
  const PairFiles files{.left = folder / "grey.png", .right = folder / "colour.tif"};
  write_png(files.left, cv::Mat1b(noise(kSize, CV_8U, 0, 256, 3)));
  write_tiff(files.right, bands_of(CV_8U, 3, 0, 256, 4), {});
  check_windows(files, folder);
}

TEST_CASE("an image that is looked at in several bands gives what the whole gives") {
  const TemporaryFolder folder;
  const cv::Size size(1500, 1700);
  const PairFiles files{.left = folder / "left.tif", .right = folder / "right.tif"};
  std::vector<cv::Mat> left{noise(size, CV_16U, 10, 900, 1)};
  left[0].at<std::uint16_t>(1699, 1400) = 2100;  // of 12 bits, as the last band tells
  write_tiff(files.left, left, {.tiled = true});
  write_tiff(files.right, {noise(size, CV_16U, 0, 900, 2)}, {.compressed = true});
  check_windows(files, folder);
}

TEST_CASE("pairs that cannot be read by windows are refused in the words of the whole reader") {
  const TemporaryFolder folder;
  const PairFiles files{.left = folder / "left.tif", .right = folder / "right.tif"};
  const auto check_refused = [&](const PairFiles& bad, const std::string& what) {
    const std::string message = error_of([&] { PairInFiles(bad, folder.path()); });
    CAPTURE(message);
    CHECK(contains(message, what));
    CHECK(message == error_of([&] { read_pair(bad); }));
  };
  write_tiff(files.left, bands_of(CV_8U, 1, 0, 256, 1), {.tiled = true});
  check_refused(files, "right.tif: no such file");
  write_tiff(files.right, bands_of(CV_16U, 1, 0, 256, 1), {.tiled = true});
  check_refused(files, "convert them to one depth");
  write_tiff(files.right, {noise({20, 20}, CV_8U, 0, 256, 1)}, {});
  check_refused(files, "give a rectified pair of one size");
  PairFiles masked{.left = files.left, .right = files.left, .left_mask = files.right};
  check_refused(masked, "a mask has the size of its image");
  for (const std::string ending : {".tif", ".png"}) {
    const std::string file = folder / ("cut" + ending);
    REQUIRE(cv::imwrite(file, noise(kSize, CV_8U, 0, 256, 1)));
    const std::string bytes = read_file(file);
    folder.write("cut" + ending, bytes.substr(0, bytes.size() * 2 / 3));
    check_refused({.left = files.left, .right = file}, "cut" + ending + ": ");
  }
}

TEST_CASE("a PNG is decoded as far as windows reach, so that only these find a damage") {
  const TemporaryFolder folder;
  const PairFiles files{.left = folder / "left.png", .right = folder / "right.png"};
  write_png(files.left, cv::Mat1b(noise(kSize, CV_8U, 0, 256, 1)));
  write_png(files.right, cv::Mat1b(noise(kSize, CV_8U, 0, 256, 2)));
  const ReadPair whole = read_pair(files);
  const PairLook look = PairInFiles(files, folder.path()).look();
  std::string bytes = read_file(files.right);
  bytes[bytes.size() / 2] ^= 0x55;
  folder.write("right.png", bytes);
  const PairInFiles windows(files, folder.path(), look);
  const cv::Rect above(5, 2, 40, 6), below(5, kSize.height - 6, 40, 6);
  CHECK(same(windows.read(above).match, crop(whole.pair, above).match));
  CHECK(contains(error_of([&] { windows.read(below); }), "is cut short or damaged at row"));
  CHECK(contains(error_of([&] { windows.read(below); }), "right.png: is damaged"));
  CHECK(same(windows.read(above).match, crop(whole.pair, above).match));
}

TEST_CASE("a PNG whose pixels are damaged is refused with the row, and a changed file later") {
  const TemporaryFolder folder;
  const std::string file = folder / "image.png", damaged = folder / "damaged.png";
  write_png(file, cv::Mat1b(noise(kSize, CV_8U, 0, 256, 1)));
  std::string bytes = read_file(file);
  bytes[bytes.size() / 2] ^= 0x55;
  folder.write("damaged.png", bytes);
  const std::string message =
      error_of([&] { PairInFiles({.left = file, .right = damaged}, folder.path()); });
  CHECK(contains(message, "damaged.png: is cut short or damaged at row"));
  CHECK(contains(message, "give a complete file"));
  CHECK(
      contains(error_of([&] { PairInFiles({.left = file, .right = file}, folder / "no_folder"); }),
               "cannot be written"));
}
