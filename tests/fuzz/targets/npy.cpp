// SPDX-License-Identifier: Apache-2.0
// Arrays of NumPy: as many numbers as the shape says, all within the file.
#include "framework/core/src/io/npy.hpp"

#include "fuzz/support/memory_file.hpp"
#include "fuzz/support/target.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"

namespace xgm::fuzz {

void check(std::string_view input) {
  static MemoryFile file;
  file.hold(input);
  NpyArray array;
  if (!accepts(file.path(), [&] { array = read_npy(file.path()); })) return;
  require(array.bytes == input, "the bytes are those of the file");
  std::size_t count = 1;
  for (const std::size_t side : array.shape) count *= side;
  const auto size = static_cast<std::size_t>(array.type.back() - '0');
  require(array.begin + count * size == input.size(), "the numbers are the rest of the file");
  for (std::size_t i = 0; i < count; ++i) {
    const double number = array.at(i);
    require(size > 1 || (number >= 0 && number <= 255), "a byte is a byte");
  }
}

std::vector<std::string> seeds() {
  const testing::TemporaryFolder folder;
  const std::string floats = folder / "floats.npy", bytes = folder / "bytes.npy";
  write_npy(floats, cv::Mat1f(3, 5, 1.5F));
  write_npy(bytes, cv::Mat(2, 3, CV_8UC4, cv::Scalar::all(7)));
  std::string second = read_file(floats);  // version 2: a length of four bytes
  second[6] = 2;
  second.insert(10, 2, '\0');
  return {read_file(floats), read_file(bytes), second};
}

std::vector<std::string> words() {
  return {"'descr': '<f8'", "'fortran_order': True", "'shape': (", "1073741824", ", ", "|u1"};
}

}  // namespace xgm::fuzz
