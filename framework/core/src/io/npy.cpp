// SPDX-License-Identifier: Apache-2.0
#include "io/npy.hpp"

#include <algorithm>
#include <bit>
#include <ostream>
#include <vector>

#include "xgm/io/file.hpp"

namespace xgm {
namespace {

std::string header(const VolumeShape& shape, std::size_t cell_bytes) {
  const bool little = std::endian::native == std::endian::little;
  const std::string type =
      cell_bytes == 1 ? "|u1" : std::string(little ? "<" : ">") + "u" + std::to_string(cell_bytes);
  std::string text = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" +
                     std::to_string(shape.height()) + ", " + std::to_string(shape.width()) + ", " +
                     std::to_string(shape.hull().size()) + "), }";
  constexpr std::size_t kPreamble = 10, kAlignment = 64;  // as the format asks
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
    stream << header(shape, sizeof(Cell));
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

}  // namespace

void write_npy(const std::string& file, const Volume<std::uint8_t>& volume) {
  write_volume(file, volume);
}
void write_npy(const std::string& file, const Volume<std::uint16_t>& volume) {
  write_volume(file, volume);
}

}  // namespace xgm
