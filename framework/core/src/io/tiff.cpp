// SPDX-License-Identifier: Apache-2.0
#include "io/tiff.hpp"

#include <algorithm>

#include "io/stored_windows.hpp"
#include "io/tiff_file.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/scalar.hpp"

namespace xgm {
namespace {

constexpr ttag_t kGdalNoData = 42113;

int depth_of(std::uint16_t format, std::uint16_t bits) {
  switch (format) {
    case SAMPLEFORMAT_UINT:
      return bits == 8 ? CV_8U : bits == 16 ? CV_16U : -1;
    case SAMPLEFORMAT_INT:
      return bits == 8 ? CV_8S : bits == 16 ? CV_16S : bits == 32 ? CV_32S : -1;
    case SAMPLEFORMAT_IEEEFP:
      return bits == 32 ? CV_32F : bits == 64 ? CV_64F : -1;
    default:
      return -1;
  }
}

std::string samples_text(std::uint16_t format, std::uint16_t bits) {
  const std::string size = std::to_string(bits) + "-bit ";
  switch (format) {
    case SAMPLEFORMAT_UINT:
      return size + "unsigned numbers";
    case SAMPLEFORMAT_INT:
      return size + "signed numbers";
    case SAMPLEFORMAT_IEEEFP:
      return size + "floats";
    case SAMPLEFORMAT_COMPLEXINT:
    case SAMPLEFORMAT_COMPLEXIEEEFP:
      return "complex numbers";
    default:
      return size + "samples of a kind that it does not tell";
  }
}

/// Whole bytes are read here, single bits and 10 to 14 of them by OpenCV.
int known_depth_of(const TiffFile& tiff) {
  const auto format = tiff.field(TIFFTAG_SAMPLEFORMAT, std::uint16_t{SAMPLEFORMAT_UINT});
  const auto bits = tiff.field(TIFFTAG_BITSPERSAMPLE, std::uint16_t{1});
  const int depth = depth_of(format, bits);
  const bool by_opencv = format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID;
  const bool known = bits == 1 || bits == 8 || (bits >= 10 && bits <= 16 && bits % 2 == 0);
  if (depth >= 0 || (by_opencv && known)) return depth;
  throw Error(tiff.name() + ": has " + samples_text(format, bits) +
              ", which are not read; convert it: gdal_translate -ot Float32 " + tiff.name() +
              " NEW.tif");
}

TiffLayout layout_of(const TiffFile& tiff) {
  TiffLayout layout;
  layout.width = tiff.field(TIFFTAG_IMAGEWIDTH, std::uint32_t{0});
  layout.height = tiff.field(TIFFTAG_IMAGELENGTH, std::uint32_t{0});
  layout.samples = tiff.field(TIFFTAG_SAMPLESPERPIXEL, std::uint16_t{1});
  layout.is_tiled = TIFFIsTiled(tiff.handle()) != 0;
  layout.bands_lie_apart =
      tiff.field(TIFFTAG_PLANARCONFIG, std::uint16_t{PLANARCONFIG_CONTIG}) == PLANARCONFIG_SEPARATE;
  const auto photometric = tiff.field(TIFFTAG_PHOTOMETRIC, std::uint16_t{PHOTOMETRIC_MINISBLACK});
  if (photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_RGB) {
    layout.depth = known_depth_of(tiff);
  }
  const std::size_t sample_bytes = layout.depth < 0 ? 1 : CV_ELEM_SIZE1(layout.depth);
  tiff.require_possible(layout.width, layout.height,
                        sample_bytes * static_cast<std::size_t>(layout.samples));
  return layout;
}

/// OpenCV decodes JPEG's colours to those that the tag speaks of. Other samples it changes.
void require_values(const TiffFile& tiff) {
  const auto photometric = tiff.field(TIFFTAG_PHOTOMETRIC, std::uint16_t{PHOTOMETRIC_MINISBLACK});
  if (photometric == PHOTOMETRIC_YCBCR) return;
  throw Error(tiff.name() +
              ": has the tag GDAL_NODATA, but its samples are not the values of its pixels (a "
              "palette, single bits, white as 0); convert it to grey or RGB");
}

/// Whether the band after the colours is alpha: if the file does not say that it is something else.
bool has_alpha(const TiffFile& tiff) {
  std::uint16_t count = 0;
  const std::uint16_t* kinds = nullptr;
  if (TIFFGetField(tiff.handle(), TIFFTAG_EXTRASAMPLES, &count, &kinds) != 1 || count == 0) {
    return true;
  }
  return kinds[0] != EXTRASAMPLE_UNSPECIFIED;
}

void turn(cv::Mat& band, std::uint16_t orientation) {
  if (orientation == ORIENTATION_TOPRIGHT) cv::flip(band, band, 1);
  if (orientation == ORIENTATION_BOTRIGHT) cv::flip(band, band, -1);
  if (orientation == ORIENTATION_BOTLEFT) cv::flip(band, band, 0);
}

std::string trimmed(std::string text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\0' || c == '\n' || c == '\r'; };
  while (!text.empty() && is_blank(text.back())) text.pop_back();
  text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), is_blank));
  return text;
}

std::optional<double> no_data_of(const TiffFile& tiff) {
  const TIFFField* field = TIFFFindField(tiff.handle(), kGdalNoData, TIFF_ANY);
  if (field == nullptr || TIFFFieldDataType(field) != TIFF_ASCII) return std::nullopt;
  std::uint32_t count = 0;
  const char* characters = nullptr;
  if (TIFFGetField(tiff.handle(), kGdalNoData, &count, &characters) != 1) return std::nullopt;
  const std::string text = trimmed(std::string(characters, count));
  const std::optional<double> value = to_number<double>(text);
  if (!value) {
    throw Error(tiff.name() + ": its tag GDAL_NODATA says '" + text +
                "', which is no number; correct it (gdal_edit.py -a_nodata VALUE) or remove it "
                "(gdal_edit.py -unsetnodata)");
  }
  return value;
}

}  // namespace

bool is_tiff(std::string_view head) {
  using namespace std::string_view_literals;
  return head.starts_with("II*\0"sv) || head.starts_with("MM\0*"sv) ||
         head.starts_with("II+\0"sv) || head.starts_with("MM\0+"sv);
}

namespace {

/// A TIFF whose samples are the values of its pixels.
class TiffImage final : public StoredWindows {
 public:
  explicit TiffImage(const std::string& file)
      : tiff_(file),
        layout_(layout_of(tiff_)),
        orientation_(tiff_.field(TIFFTAG_ORIENTATION, std::uint16_t{ORIENTATION_TOPLEFT})),
        no_data_(no_data_of(tiff_)) {
    if (layout_.depth < 0 && no_data_) require_values(tiff_);
    if (is_for_opencv() || layout_.samples <= 4) return;
    throw Error(file + ": has " + std::to_string(layout_.samples) +
                " channels; give a grey (1) or colour (3) image, with or without alpha");
  }

  bool is_for_opencv() const { return layout_.depth < 0 || orientation_ > ORIENTATION_BOTLEFT; }
  const std::optional<double>& no_data() const { return no_data_; }
  std::size_t chunk_bytes() const { return chunk_of(tiff_, layout_).bytes; }

  cv::Size size() const override {
    return {static_cast<int>(layout_.width), static_cast<int>(layout_.height)};
  }

  StoredImage read(const cv::Rect& window) override {
    StoredImage image;
    image.no_data = no_data_;
    std::vector<cv::Mat> bands = read_bands(tiff_, layout_, in_file(window));
    for (cv::Mat& band : bands) turn(band, orientation_);
    const std::size_t colours = bands.size() > 2 ? 3 : 1;
    if (bands.size() > colours && has_alpha(tiff_)) image.alpha = bands.back();
    bands.resize(colours);
    image.channels.assign(bands.rbegin(), bands.rend());  // red is stored first, and kept last
    return image;
  }

 private:
  /// Where the pixels of a window lie before the image is turned.
  cv::Rect in_file(cv::Rect window) const {
    const bool right = orientation_ == ORIENTATION_TOPRIGHT || orientation_ == ORIENTATION_BOTRIGHT;
    const bool bottom = orientation_ == ORIENTATION_BOTLEFT || orientation_ == ORIENTATION_BOTRIGHT;
    if (right) window.x = size().width - window.br().x;
    if (bottom) window.y = size().height - window.br().y;
    return window;
  }

  TiffFile tiff_;
  TiffLayout layout_;
  std::uint16_t orientation_;
  std::optional<double> no_data_;
};

}  // namespace

StoredImage read_tiff(const std::string& file) {
  TiffImage tiff(file);
  if (!tiff.is_for_opencv()) return tiff.read({{}, tiff.size()});
  StoredImage none;
  none.no_data = tiff.no_data();
  return none;
}

std::unique_ptr<StoredWindows> open_tiff(const std::string& file) {
  constexpr std::size_t kLargestChunk = std::size_t{1} << 26;
  auto tiff = std::make_unique<TiffImage>(file);
  if (tiff->is_for_opencv() || tiff->chunk_bytes() > kLargestChunk) return nullptr;
  return tiff;
}

}  // namespace xgm
