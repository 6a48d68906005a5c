// SPDX-License-Identifier: Apache-2.0
#include "io/pfm_in_parts.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <limits>

#include "xgm/base/error.hpp"

namespace xgm {
namespace {

constexpr std::int64_t kPixel = sizeof(float);

std::string header_of(cv::Size size) {
  constexpr bool kBig = std::endian::native == std::endian::big;
  return "Pf\n" + std::to_string(size.width) + ' ' + std::to_string(size.height) + '\n' +
         (kBig ? "1.0\n" : "-1.0\n");
}

float stored(float value) {
  return std::isfinite(value) ? value : std::numeric_limits<float>::infinity();
}

}  // namespace

PfmInParts::PfmInParts(const std::string& file, cv::Size size)
    : name_(file), size_(size), file_(file), missing_(std::int64_t{size.width} * size.height) {
  open_.number = ::open(file_.path().c_str(), O_WRONLY | O_CLOEXEC);
  if (open_.number < 0) throw_unwritable(name_, errno);
  const std::string header = header_of(size);
  pixels_begin_ = static_cast<std::int64_t>(header.size());
  // A file system that cannot reserve room says so, and fails when it is full.
  const int failure = ::posix_fallocate(open_.number, 0, pixels_begin_ + missing_ * kPixel);
  if (failure == ENOSPC || failure == EFBIG || failure == EDQUOT) throw_unwritable(name_, failure);
  write(header.data(), header.size(), 0);
}

PfmInParts::Open::~Open() {
  if (number >= 0) ::close(number);
}

void PfmInParts::write(const void* data, std::size_t bytes, std::int64_t at) const {
  const auto* next = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t written = ::pwrite(open_.number, next, bytes, at);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw_unwritable(name_, errno);
    next += written;
    at += written;
    bytes -= static_cast<std::size_t>(written);
  }
}

void PfmInParts::put(const cv::Rect& place, const cv::Mat1f& part) {
  row_.resize(static_cast<std::size_t>(place.width));
  for (int y = 0; y < place.height; ++y) {
    std::transform(part[y], part[y] + place.width, row_.begin(), stored);
    const std::int64_t row = size_.height - 1 - (place.y + y);  // rows are stored bottom-up
    write(row_.data(), row_.size() * sizeof(float),
          pixels_begin_ + (row * size_.width + place.x) * kPixel);
  }
  missing_ -= place.area();
}

void PfmInParts::finish() {
  if (missing_ != 0) throw Error(name_ + ": is not written, as parts of the map are missing");
  const int failed = ::close(open_.number);
  open_.number = -1;
  if (failed != 0) throw_unwritable(name_, errno);
  file_.publish();
}

}  // namespace xgm
