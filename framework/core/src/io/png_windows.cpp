// SPDX-License-Identifier: Apache-2.0
// PNG by libpng, row by row: OpenCV decodes whole images only.
#include <png.h>

#include <bit>
#include <cstdio>
#include <memory>
#include <vector>

#include "io/image_formats.hpp"
#include "io/possible_size.hpp"
#include "io/scratch_image.hpp"
#include "io/stored_windows.hpp"
#include "io/whole_file.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"

namespace xgm {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Rows as OpenCV gives them: blue before red, the byte order of the machine, grey with alpha as
/// colour with alpha.
class PngRows {
 public:
  explicit PngRows(const std::string& name)
      : name_(name), file_(std::fopen(name.c_str(), "rb"), std::fclose) {
    if (!file_) throw Error(name + ": " + why_unreadable(name));
    png_init_io(reader_.png, file_.get());
    png_set_user_limits(reader_.png, kMaxSide, kMaxSide);
    png_read_info(reader_.png, reader_.info);
  }

  bool has_plain_rows() const {
    const double pixels = double{1} * size().width * size().height;
    return pixels <= kMaxPixels &&
           png_get_interlace_type(reader_.png, reader_.info) == PNG_INTERLACE_NONE &&
           png_get_color_type(reader_.png, reader_.info) != PNG_COLOR_TYPE_PALETTE &&
           png_get_bit_depth(reader_.png, reader_.info) >= 8 &&
           png_get_valid(reader_.png, reader_.info, PNG_INFO_tRNS) == 0;
  }

  cv::Size size() const {
    return {static_cast<int>(png_get_image_width(reader_.png, reader_.info)),
            static_cast<int>(png_get_image_height(reader_.png, reader_.info))};
  }

  /// OpenCV's type of a pixel.
  int type() const {
    const int colours = png_get_color_type(reader_.png, reader_.info);
    const int bands = (colours & PNG_COLOR_MASK_ALPHA) != 0   ? 4
                      : (colours & PNG_COLOR_MASK_COLOR) != 0 ? 3
                                                              : 1;
    return CV_MAKETYPE(png_get_bit_depth(reader_.png, reader_.info) == 16 ? CV_16U : CV_8U, bands);
  }

  void read_into(ScratchImage& image) {
    const int colours = png_get_color_type(reader_.png, reader_.info);
    if (std::endian::native == std::endian::little) png_set_swap(reader_.png);
    if ((colours & PNG_COLOR_MASK_COLOR) != 0) png_set_bgr(reader_.png);
    if (colours == PNG_COLOR_TYPE_GRAY_ALPHA) png_set_gray_to_rgb(reader_.png);
    png_read_update_info(reader_.png, reader_.info);
    std::vector<unsigned char> row(png_get_rowbytes(reader_.png, reader_.info));
    for (row_ = 0; row_ < size().height; ++row_) {
      png_read_row(reader_.png, row.data(), nullptr);
      image.append(row.data());
    }
  }

 private:
  static constexpr png_uint_32 kMaxSide = 1 << 20;  // OpenCV's limits, too
  static constexpr double kMaxPixels = 1 << 30;

  struct Reader {
    explicit Reader(PngRows* rows)
        : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, rows, fail, ignore)),
          info(png_create_info_struct(png)) {}
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    png_structp png;
    png_infop info;
  };

  /// libpng's handlers. It allows that the first one throws: nothing of it is used afterwards but
  /// what destroys it.
  static void fail(png_structp png, png_const_charp what) {
    const auto* const rows = static_cast<const PngRows*>(png_get_error_ptr(png));
    throw Error(rows->name_ + ": is cut short or damaged at row " + std::to_string(rows->row_) +
                " (" + what + "); give a complete file");
  }
  static void ignore(png_structp, png_const_charp) {}

  std::string name_;
  File file_;
  int row_ = 0;
  Reader reader_{this};
};

}  // namespace

std::unique_ptr<StoredWindows> open_png(const std::string& file, const std::string& scratch) {
  const std::string head = read_head(file, kImageHead);
  require_possible_header(file, head);
  require_whole(file, head);
  PngRows rows(file);
  if (!rows.has_plain_rows()) return nullptr;
  auto image = std::make_unique<ScratchImage>(scratch, rows.size(), rows.type());
  rows.read_into(*image);
  image->finish();
  return image;
}

}  // namespace xgm
