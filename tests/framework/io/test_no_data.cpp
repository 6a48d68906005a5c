// SPDX-License-Identifier: Apache-2.0
// Which values mean no data: the table of docs/conventions.md, each cell of it.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <sstream>

#include "support/paths.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "support/tiff_file.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/scene.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;
using xgm::testing::TiffStyle;
using xgm::testing::write_tiff;

namespace {

constexpr int kSize = 64;
constexpr int kHeld = 3;  // so many pixels, from the left of the first row, hold the value

/// A file with a value to be looked at.
struct Sample {
  double value = 0;
  int depth = CV_32F;
  TiffStyle style{};
  std::vector<double> no_data{};
  bool with_alpha = false;
};

std::string write(const TemporaryFolder& folder, const Sample& sample) {
  cv::Mat1d values(kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) values(y, x) = 10 + (x + y) % 40 + 0.25;
  }
  values(cv::Rect(0, 0, kHeld, 1)).setTo(sample.value);
  std::vector<cv::Mat> bands(1);
  values.convertTo(bands.front(), sample.depth);
  if (sample.with_alpha) {
    bands.emplace_back(values.size(), sample.depth, cv::Scalar(255)).colRange(0, kHeld).setTo(0);
  }
  const std::string file = folder / "sample.tif";
  write_tiff(file, bands, sample.style);
  return file;
}

std::string outcome(bool has_data, const std::vector<std::string>& warnings) {
  return std::string(has_data ? "value" : "none") + (warnings.empty() ? "" : ", warned");
}

/// What the readers make of the first pixel, in the words of the table.
std::string as_image(const std::string& file, const Sample& sample) {
  const ReadPair read = read_pair({file, file, "", "", sample.no_data});
  return outcome(read.pair.base.is_valid(0, 0), read.warnings);
}

std::string as_mask(const std::string& file, const Sample&) {
  const Noted<cv::Mat1b> read = read_mask(file, MaskUse::objects);
  return outcome(read.value(0, 0) != 0, {});
}

std::string as_map(const std::string& file, const Sample& sample) {
  const bool whole = sample.depth == CV_16U;
  const auto divisor = whole ? std::optional<double>(1100) : std::nullopt;  // 65535: 59.6 px
  const Noted<cv::Mat1f> read = read_disparities(file, divisor, sample.no_data);
  return outcome(std::isfinite(read.value(0, 0)), read.warnings);
}

std::string as_range_map(const std::string& file, const Sample& sample) {
  std::string result = "refused";
  error_of([&] {
    const Noted<DisparityRange> read = read_range_maps(file, file, sample.no_data);
    result = outcome(!read.value.at(0, 0).empty(), read.warnings);
  });
  return result;
}

/// The samples of a row, by the row's first cell.
const std::map<std::string, std::vector<Sample>>& samples() {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  static const std::map<std::string, std::vector<Sample>> all{
      {"NaN, inf or -inf", {{kNan}, {kInf}, {-kInf}}},
      {"any, with alpha 0", {{.value = 30, .style = {.has_alpha = true}, .with_alpha = true}}},
      {"that of the tag GDAL_NODATA",
       {{.value = -9999, .style = {.no_data = "-9999"}},
        {.value = 7, .style = {.no_data = "7"}},
        {.value = 0, .style = {.no_data = "0"}},
        {.value = std::numeric_limits<float>::lowest(),
         .style = {.no_data = "-3.4028234663852886e+38"}}}},
      {"one that is named as no data", {{.value = -9999, .no_data = {0, -9999}}}},
      {"0 in a file of whole numbers", {{.value = 0, .depth = CV_16U}}},
      {"0 or -0 in a file of floats", {{.value = 0}, {.value = -0.0}}},
      {"a denormal number, 1e-40", {{.value = 1e-40}}},
      {"too large for anything, 3.4e38",
       {{.value = 3.4e38},
        {.value = -3.4e38},
        {.value = std::numeric_limits<float>::max()},
        {.value = std::numeric_limits<float>::lowest()}}},
      {"a mark, -9999", {{.value = -9999}, {.value = -32768}, {.value = -99999}}},
      {"the only negative value, -1", {{.value = -1}, {.value = -16}}},
      {"the largest 16-bit value, 65535", {{.value = 65535, .depth = CV_16U}}},
  };
  return all;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// The rows of the table, cell by cell.
std::vector<std::vector<std::string>> table() {
  std::istringstream text(read_file(XGM_SOURCE_DIR "/docs/conventions.md"));
  std::vector<std::vector<std::string>> rows;
  bool inside = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("| Value of the pixel |")) {
      inside = true;
    } else if (inside && !line.starts_with("|")) {
      break;
    } else if (inside && !line.starts_with("|---")) {
      std::vector<std::string>& row = rows.emplace_back();
      std::istringstream cells(line.substr(1));
      for (std::string cell; std::getline(cells, cell, '|');) row.push_back(trimmed(cell));
    }
  }
  return rows;
}

using Reader = std::function<std::string(const std::string&, const Sample&)>;

}  // namespace

TEST_CASE("no data: every cell of the table in docs/conventions.md is what the readers do") {
  const TemporaryFolder folder;
  const std::vector<Reader> readers{as_image, as_mask, as_map, as_range_map};
  const auto rows = table();
  CHECK(rows.size() == samples().size());
  for (const std::vector<std::string>& row : rows) {
    CAPTURE(row.front());
    REQUIRE(row.size() == 1 + readers.size());
    REQUIRE(samples().contains(row.front()));
    for (const Sample& sample : samples().at(row.front())) {
      CAPTURE(sample.value);
      const std::string file = write(folder, sample);
      for (std::size_t i = 0; i < readers.size(); ++i) {
        CAPTURE(i);
        CHECK(readers[i](file, sample) == row[i + 1]);
      }
    }
  }
}

TEST_CASE(
    "no data: a warning names file, pixels and value; several marks in one map are all found") {
  const TemporaryFolder folder;
  cv::Mat1f map(kSize, kSize);
  for (int i = 0; i < kSize * kSize; ++i) map(i) = static_cast<float>(i % 50) + 0.5f;
  map.row(0).setTo(-9999);
  map.row(1).setTo(-32768);
  map.row(2).setTo(1e10f);
  map(3, 3) = std::numeric_limits<float>::max();
  const std::string file = folder / "map.tif";
  write_tiff(file, {map});
  const auto [read, warnings] = read_disparities(file);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const bool is_mark = y < 3 || (y == 3 && x == 3);
      CHECK((is_mark ? std::isnan(read(y, x)) : read(y, x) == map(y, x)));
    }
  }
  REQUIRE(warnings.size() == 3);
  CHECK(contains(warnings[0], file + ": 65 of 4096 pixels hold values such as"));
  CHECK(contains(warnings[1], file + ": 64 of 4096 pixels hold -32768"));
  CHECK(contains(warnings[2], file + ": 64 of 4096 pixels hold -9999"));
}

TEST_CASE("no data: an outlier, a flat plane and a map of few values are no marks") {
  const TemporaryFolder folder;
  const std::string file = folder / "map.tif";
  const auto warnings_of = [&](const cv::Mat1f& map) {
    write_tiff(file, {map});
    const auto [read, warnings] = read_disparities(file);
    CHECK(cv::norm(read, map, cv::NORM_INF) == 0);
    return warnings.size();
  };
  cv::Mat1f map(8, 8, 5.0f);
  CHECK(warnings_of(map) == 0);
  map.row(2).setTo(7.5f);
  CHECK(warnings_of(map) == 0);
  map(0, 0) = -300;  // a matcher's fault is to be judged as one
  CHECK(warnings_of(map) == 0);
  map.row(4).setTo(-3);
  map.row(5).setTo(-4);
  CHECK(warnings_of(map) == 0);
  CHECK(warnings_of(cv::Mat1f(8, 8, 100.0f)) == 0);  // wider than the image, but all there is
}

TEST_CASE("no data: values named by the caller are compared before the divisor") {
  const TemporaryFolder folder;
  write_png(folder / "truth.png", cv::Mat1w((cv::Mat1w(1, 3) << 65535, 256, 512)));
  const auto [map, warnings] = read_disparities(folder / "truth.png", 256, {65535, 2});
  CHECK(std::isnan(map(0)));
  CHECK(map(1) == 1);
  CHECK(map(2) == 2);
  CHECK(warnings.empty());
  const ReadPair pair = read_pair({folder / "truth.png", folder / "truth.png", "", "", {256}});
  CHECK(pair.pair.base.is_valid(0, 0));
  CHECK_FALSE(pair.pair.base.is_valid(0, 1));
}
