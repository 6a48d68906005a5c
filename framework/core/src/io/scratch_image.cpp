// SPDX-License-Identifier: Apache-2.0
#include "io/scratch_image.hpp"

#include <cerrno>
#include <filesystem>

#include "xgm/base/error.hpp"

namespace xgm {
namespace {

std::string name_in(const std::string& folder) {
  return (std::filesystem::path(folder) / "decoded pixels").string();
}

}  // namespace

ScratchImage::ScratchImage(const std::string& folder, cv::Size size, int type)
    : name_(name_in(folder)),
      size_(size),
      type_(type),
      file_(name_),
      stream_(file_.path(), std::ios::binary | std::ios::in | std::ios::out) {
  if (!stream_) throw_unwritable(name_, errno);
}

std::size_t ScratchImage::row_bytes() const {
  return static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(CV_ELEM_SIZE(type_));
}

void ScratchImage::append(const unsigned char* row) {
  const std::size_t begin = static_cast<std::size_t>(rows_++) * row_bytes();
  stream_.seekp(static_cast<std::streamoff>(begin));  // windows may have been read meanwhile
  stream_.write(reinterpret_cast<const char*>(row), static_cast<std::streamsize>(row_bytes()));
  if (!stream_) throw_unwritable(name_, errno);
}

void ScratchImage::finish() {
  stream_.flush();
  if (!stream_) throw_unwritable(name_, errno);
}

StoredImage ScratchImage::read(const cv::Rect& window) {
  cv::Mat pixels(window.size(), type_);
  const std::size_t pixel = pixels.elemSize();
  for (int y = 0; y < window.height; ++y) {
    const std::size_t begin = static_cast<std::size_t>(window.y + y) * row_bytes() +
                              static_cast<std::size_t>(window.x) * pixel;
    stream_.seekg(static_cast<std::streamoff>(begin));
    stream_.read(reinterpret_cast<char*>(pixels.ptr(y)),
                 static_cast<std::streamsize>(static_cast<std::size_t>(window.width) * pixel));
    if (!stream_) throw Error(name_ + ": cannot be read again; check the disk");
  }
  return split_bands(pixels);
}

}  // namespace xgm
