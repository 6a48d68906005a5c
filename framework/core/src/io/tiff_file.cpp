// SPDX-License-Identifier: Apache-2.0
#include "io/tiff_file.hpp"

#include <cstdarg>
#include <cstdio>
#include <memory>

#include "io/possible_size.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace {

/// libtiff's handlers: its messages go into the text `user`, not to the standard error.
int keep_message(TIFF*, void* user, const char*, const char* format, va_list arguments) {
  char text[256];
  std::vsnprintf(text, sizeof text, format, arguments);
  *static_cast<std::string*>(user) = text;
  return 1;
}
int ignore_message(TIFF*, void*, const char*, const char*, va_list) { return 1; }

}  // namespace

TiffFile::TiffFile(const std::string& name) : name_(name) {
  const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                             TIFFOpenOptionsFree);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_message, &message_);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_message, nullptr);
  // Not mapped into memory: what has been read of a large file would count as taken.
  handle_ = TIFFOpenExt(name.c_str(), "rm", options.get());
  if (handle_ == nullptr) fail("is no TIFF that can be read");
}

TiffFile::~TiffFile() {
  if (handle_ != nullptr) TIFFClose(handle_);
}

void TiffFile::fail(const std::string& what) const {
  const std::string why = message_.empty() ? "" : " (" + message_ + ")";
  throw Error(name_ + ": " + what + why + "; give a complete file");
}

void TiffFile::require_possible(std::uint32_t width, std::uint32_t height,
                                std::size_t pixel_bytes) const {
  constexpr std::uint32_t kMaxSide = 1 << 20;
  constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 30;  // OpenCV's limit, too
  const std::uint64_t pixels = std::uint64_t{width} * height;
  if (pixels > 0 && pixels <= kMaxPixels && width <= kMaxSide && height <= kMaxSide) {
    return require_possible_size(name_, pixels * pixel_bytes);
  }
  fail("has a broken header: " + std::to_string(width) + " x " + std::to_string(height) +
       " pixels");
}

}  // namespace xgm
