// SPDX-License-Identifier: Apache-2.0
// PNM: the portable bitmaps, grey maps and pixmaps of Netpbm, and its PAM.
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>

#include "io/whole_file.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/scalar.hpp"
#include "xgm/io/file.hpp"

namespace xgm {
namespace {

/// Reads the words of a header, and the numbers of a text format. '#' begins a comment.
class Words {
 public:
  Words(const std::string& bytes, std::size_t at) : bytes_(bytes), at_(at) {}

  std::string next() {
    while (at_ < bytes_.size()) {
      if (bytes_[at_] == '#') {
        at_ = std::min(bytes_.find('\n', at_), bytes_.size());
      } else if (is_space(bytes_[at_])) {
        ++at_;
      } else {
        break;
      }
    }
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && !is_space(bytes_[at_]) && bytes_[at_] != '#') ++at_;
    return bytes_.substr(begin, at_ - begin);
  }
  std::size_t position() const { return at_; }

 private:
  static bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

  const std::string& bytes_;
  std::size_t at_;
};

struct Header {
  std::uint64_t width = 0, height = 0, samples = 1, largest = 1;
  std::size_t end = 0;  ///< where the pixels begin: behind one white space
};

Header pnm_header(const std::string& bytes) {
  Words words(bytes, 2);
  const auto number = [&words] { return to_number<std::uint32_t>(words.next()).value_or(0); };
  const char kind = bytes[1];
  Header header;
  header.samples = kind == '3' || kind == '6' ? 3 : 1;
  header.width = number();
  header.height = number();
  if (kind != '1' && kind != '4') header.largest = number();
  header.end = words.position() + 1;
  return header;
}

Header pam_header(const std::string& bytes) {
  Words words(bytes, 2);
  Header header;
  for (std::string word = words.next(); word != "ENDHDR"; word = words.next()) {
    if (word.empty()) return {};
    const std::string value = words.next();
    const std::uint64_t number = to_number<std::uint32_t>(value).value_or(0);
    if (word == "WIDTH") header.width = number;
    if (word == "HEIGHT") header.height = number;
    if (word == "DEPTH") header.samples = number;
    if (word == "MAXVAL") header.largest = number;
  }
  header.end = words.position() + 1;
  return header;
}

/// Text has no length to compare: the numbers are counted. A bitmap's digits may touch each other.
void require_numbers(const std::string& file, const std::string& bytes, const Header& header) {
  const bool is_bitmap = bytes[1] == '1';
  const std::uint64_t needed = header.width * header.height * header.samples;
  std::uint64_t found = 0;
  Words words(bytes, header.end - 1);
  for (std::string word = words.next(); !word.empty(); word = words.next()) {
    found += is_bitmap ? word.size() : 1;
  }
  if (found == needed) return;
  throw Error(file + ": holds " + std::to_string(found) + " numbers where its header says " +
              std::to_string(needed) + "; copy it again");
}

std::uint64_t bytes_of_pixels(char kind, const Header& header) {
  if (kind == '4') return (header.width + 7) / 8 * header.height;
  return header.width * header.height * header.samples * (header.largest > 255 ? 2 : 1);
}

}  // namespace

void require_whole_pnm(const std::string& file) {
  constexpr std::size_t kLongestHeader = 1 << 16;
  constexpr std::uint64_t kMax = 1 << 20, kMaxValue = 65535;
  const std::string head = read_head(file, kLongestHeader);
  const char kind = head[1];
  const Header header = kind == '7' ? pam_header(head) : pnm_header(head);
  if (header.width - 1 >= kMax || header.height - 1 >= kMax || header.samples - 1 >= kMax ||
      header.largest - 1 >= kMaxValue) {
    throw Error(file +
                ": has a broken header; expected P1 to P7 with width, height and largest value");
  }
  if (kind <= '3') {
    require_numbers(file, read_file(file), header);
  } else {
    require_length(file, std::filesystem::file_size(file),
                   header.end + bytes_of_pixels(kind, header));
  }
}

}  // namespace xgm
