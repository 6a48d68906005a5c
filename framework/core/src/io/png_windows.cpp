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

  /// Before the first row; size() and type() stay.
  void begin() {
    const int colours = png_get_color_type(reader_.png, reader_.info);
    if (std::endian::native == std::endian::little) png_set_swap(reader_.png);
    if ((colours & PNG_COLOR_MASK_COLOR) != 0) png_set_bgr(reader_.png);
    if (colours == PNG_COLOR_TYPE_GRAY_ALPHA) png_set_gray_to_rgb(reader_.png);
    png_read_update_info(reader_.png, reader_.info);
    pixels_.resize(png_get_rowbytes(reader_.png, reader_.info));
  }

  /// The next row, from the top. Throws Error; there are no more rows then.
  const unsigned char* next() {
    png_read_row(reader_.png, pixels_.data(), nullptr);
    ++row_;
    return pixels_.data();
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
  std::vector<unsigned char> pixels_{};
  Reader reader_{this};
};

/// Decodes rows once they are asked for, with those above them: who needs the upper part of an
/// image does not wait for the rest.
class PngWindows final : public StoredWindows {
 public:
  PngWindows(const std::string& file, std::unique_ptr<PngRows> rows, const std::string& scratch)
      : file_(file), rows_(std::move(rows)), image_(scratch, rows_->size(), rows_->type()) {
    rows_->begin();
  }

  cv::Size size() const override { return image_.size(); }

  StoredImage read(const cv::Rect& window) override {
    if (window.br().y > image_.rows()) decode(window.br().y);
    return image_.read(window);
  }

 private:
  void decode(int end) {
    auto rows = std::move(rows_);  // nothing can be read of it any more when it has failed
    if (!rows) throw Error(file_ + ": is damaged; give a complete file");
    while (image_.rows() < end) image_.append(rows->next());
    image_.finish();
    if (end < image_.size().height) rows_ = std::move(rows);
  }

  std::string file_;
  std::unique_ptr<PngRows> rows_;  ///< null: all are decoded, or a row is damaged
  ScratchImage image_;
};

}  // namespace

std::unique_ptr<StoredWindows> open_png(const std::string& file, const std::string& scratch) {
  const std::string head = read_head(file, kImageHead);
  require_possible_header(file, head);
  require_whole(file, head);
  auto rows = std::make_unique<PngRows>(file);
  if (!rows->has_plain_rows()) return nullptr;
  return std::make_unique<PngWindows>(file, std::move(rows), scratch);
}

}  // namespace xgm
