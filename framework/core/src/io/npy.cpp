// SPDX-License-Identifier: Apache-2.0
#include "io/npy.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <ostream>
#include <sstream>
#include <utility>

#include "io/whole_file.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/scalar.hpp"
#include "xgm/io/file.hpp"

namespace xgm {
namespace {

constexpr std::size_t kPreamble = 10;  // of version 1: what it is, version, length of the header

/// `kind`: u, i or f. Of an array of two or three axes.
std::string header(char kind, std::size_t cell_bytes, const std::vector<int>& shape) {
  const bool little = std::endian::native == std::endian::little;
  std::string text = "{'descr': '";
  text += cell_bytes == 1 ? '|' : little ? '<' : '>';
  text += kind + std::to_string(cell_bytes) + "', 'fortran_order': False, 'shape': (";
  for (std::size_t i = 0; i < shape.size(); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(shape[i]);
  }
  text += "), }";
  constexpr std::size_t kAlignment = 64;  // as the format asks
  while ((kPreamble + text.size() + 1) % kAlignment != 0) text += ' ';
  text += '\n';
  const std::string magic("\x93NUMPY\x01\x00", 8);
  return magic + static_cast<char>(text.size() & 0xff) + static_cast<char>(text.size() >> 8) + text;
}

template <class Cell>
void write_volume(const std::string& file, const Volume<Cell>& volume) {
  const VolumeShape& shape = volume.shape();
  const Interval hull = shape.hull();
  const auto depth = static_cast<std::size_t>(hull.size());
  std::vector<Cell> row(static_cast<std::size_t>(shape.width()) * depth);
  write_file(file, [&](std::ostream& stream) {
    stream << header('u', sizeof(Cell), {shape.height(), shape.width(), hull.size()});
    for (int y = 0; y < shape.height(); ++y) {
      std::fill(row.begin(), row.end(), Volume<Cell>::kNoMatch);
      for (int x = 0; x < shape.width(); ++x) {
        if (shape.count(y, x) == 0) continue;
        const std::size_t first = static_cast<std::size_t>(x) * depth +
                                  static_cast<std::size_t>(shape.begin(y, x) - hull.begin);
        std::copy_n(volume.at(y, x), shape.count(y, x), &row[first]);
      }
      stream.write(reinterpret_cast<const char*>(row.data()),
                   static_cast<std::streamsize>(row.size() * sizeof(Cell)));
    }
  });
}

/// What stands behind a key of the header, up to `end`.
std::string value_of(const std::string& header, const std::string& key, char end,
                     const std::string& file) {
  const std::size_t found = header.find("'" + key + "':");
  const std::size_t begin = found == std::string::npos ? found : header.find(':', found) + 1;
  const std::size_t last = found == std::string::npos ? found : header.find(end, begin);
  if (last == std::string::npos) {
    throw Error(file + ": has a broken header of NumPy: it does not tell '" + key + "'");
  }
  std::string value = header.substr(begin, last - begin);
  std::erase_if(value, [](char c) { return c == ' ' || c == '\'' || c == '('; });
  return value;
}

std::vector<std::size_t> shape_of(const std::string& text, const std::string& file) {
  std::vector<std::size_t> shape;
  std::istringstream sides(text);
  for (std::string side; std::getline(sides, side, ',');) {
    constexpr int kMaxSide = 1 << 30;
    const auto value = to_number<int>(side);
    if (!value || *value < 0 || *value > kMaxSide) {
      throw Error(file + ": has a broken header of NumPy: its shape is (" + text + ")");
    }
    shape.push_back(static_cast<std::size_t>(*value));
  }
  return shape;
}

std::string type_of(const std::string& descr, const std::string& file) {
  const char native = std::endian::native == std::endian::little ? '<' : '>';
  if (descr == "|u1" || descr == native + std::string("f4") ||
      descr == native + std::string("f8")) {
    return descr.substr(1);
  }
  throw Error(file + ": holds numbers of type '" + descr +
              "'; write float32, float64 or uint8, in the byte order of this machine");
}

/// Where the header begins and how long it is.
std::pair<std::size_t, std::size_t> header_of(const std::string& bytes, const std::string& file) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  if (bytes.size() < kPreamble || !bytes.starts_with("\x93NUMPY")) {
    throw Error(file + ": is no file of NumPy; write it with numpy.save");
  }
  if (byte(6) == 1) return {kPreamble, byte(8) + std::size_t{256} * byte(9)};
  constexpr std::size_t kLonger = 12;  // the length has four bytes from version 2 on
  if (bytes.size() < kLonger) throw Error(file + ": is cut short");
  std::size_t length = 0;
  for (std::size_t i = kLonger; i-- > 8;) length = length * 256 + byte(i);
  return {kLonger, length};
}

}  // namespace

std::string shape_text(const std::vector<std::size_t>& shape) {
  std::string text;
  for (const std::size_t side : shape) text += (text.empty() ? "" : ", ") + std::to_string(side);
  return "(" + text + ")";
}

double NpyArray::at(std::size_t i) const {
  const char* const first = bytes.data() + begin;
  if (type == "u1") return static_cast<unsigned char>(first[i]);
  if (type == "f8") {
    double value = 0;
    std::memcpy(&value, first + i * sizeof value, sizeof value);
    return value;
  }
  float value = 0;
  std::memcpy(&value, first + i * sizeof value, sizeof value);
  return static_cast<double>(value);
}

NpyArray read_npy(const std::string& file) {
  NpyArray array;
  array.bytes = read_file(file);
  const auto [start, length] = header_of(array.bytes, file);
  if (start + length > array.bytes.size()) throw Error(file + ": is cut short");
  const std::string header = array.bytes.substr(start, length);
  array.begin = start + length;
  array.type = type_of(value_of(header, "descr", ',', file), file);
  array.shape = shape_of(value_of(header, "shape", ')', file), file);
  if (value_of(header, "fortran_order", ',', file) != "False") {
    throw Error(file + ": is in the order of Fortran; write numpy.ascontiguousarray of it");
  }
  std::size_t needed = static_cast<std::size_t>(array.type[1] - '0');
  for (const std::size_t side : array.shape) {
    needed *= side;  // as long as that is a length that a file may have
    if (side > 0 && needed / side > array.bytes.size()) break;
  }
  require_length(file, array.bytes.size(), array.begin + needed);
  return array;
}

void write_npy(const std::string& file, const cv::Mat& matrix) {
  const char kind = matrix.depth() == CV_32F ? 'f' : matrix.depth() == CV_32S ? 'i' : 'u';
  std::vector<int> shape{matrix.rows, matrix.cols};
  if (matrix.channels() > 1) shape.push_back(matrix.channels());
  write_file(file, [&](std::ostream& stream) {
    stream << header(kind, matrix.elemSize1(), shape);
    for (int y = 0; y < matrix.rows; ++y) {
      stream.write(
          matrix.ptr<char>(y),
          static_cast<std::streamsize>(static_cast<std::size_t>(matrix.cols) * matrix.elemSize()));
    }
  });
}

void write_npy(const std::string& file, const Volume<std::uint8_t>& volume) {
  write_volume(file, volume);
}
void write_npy(const std::string& file, const Volume<std::uint16_t>& volume) {
  write_volume(file, volume);
}

}  // namespace xgm
