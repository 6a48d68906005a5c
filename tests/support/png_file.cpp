// SPDX-License-Identifier: Apache-2.0
#include "support/png_file.hpp"

#include <doctest/doctest.h>
#include <png.h>

#include <array>
#include <cstdio>
#include <memory>
#include <vector>

namespace xgm::testing {
namespace {

void write_palette(png_structp png, png_infop info) {
  std::array<png_color, 256> colours{};
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const auto level = static_cast<png_byte>(i);
    colours[i] = {level, static_cast<png_byte>(255 - i), static_cast<png_byte>(i / 2)};
  }
  png_set_PLTE(png, info, colours.data(), static_cast<int>(colours.size()));
}

}  // namespace

void write_png_as(const std::string& file, const cv::Mat& pixels, const PngStyle& style) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "wb"),
                                                               std::fclose);
  REQUIRE(stream != nullptr);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, stream.get());
  png_set_IHDR(png, info, static_cast<png_uint_32>(pixels.cols),
               static_cast<png_uint_32>(pixels.rows), pixels.depth() == CV_16U ? 16 : 8,
               style.colour_type, style.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (style.colour_type == PNG_COLOR_TYPE_PALETTE) write_palette(png, info);
  png_color_16 transparent{};
  if (style.transparent_colour) png_set_tRNS(png, info, nullptr, 0, &transparent);
  png_write_info(png, info);
  png_set_swap(png);
  cv::Mat copy = pixels.clone();
  std::vector<png_bytep> rows;
  for (int y = 0; y < copy.rows; ++y) rows.push_back(copy.ptr(y));
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
}

}  // namespace xgm::testing
