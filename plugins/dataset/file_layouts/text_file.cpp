// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/file_layouts/text_file.hpp"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

#include "xgm/base/error.hpp"

namespace xgm::dataset {
namespace {

constexpr std::size_t kMaxBytes = 1 << 16;
constexpr std::string_view kSpace = " \t\r\n";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Lines end in LF, CR LF or CR.
std::vector<Line> split_lines(const std::string& text, const std::string& file) {
  std::vector<Line> lines;
  std::size_t begin = 0;
  for (int number = 1; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    const std::string_view line = trimmed(std::string_view(text).substr(begin, end - begin));
    if (!line.empty()) lines.push_back({file + ":" + std::to_string(number), std::string(line)});
    begin = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }
  return lines;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::vector<Line> read_lines(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(kMaxBytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad() || !stream.is_open()) {
    throw Error(file + ": cannot be read: " + std::strerror(errno) +
                "; check the file and its permissions");
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > kMaxBytes) {
    throw Error(file + ": larger than 64 KB, which no such file is; check what it is");
  }
  if (text.find('\0') != std::string::npos) {
    throw Error(file + ": holds zero bytes, as UTF-16 does; save it as plain text or UTF-8");
  }
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  const std::vector<Line> lines = split_lines(text, file);
  if (lines.empty()) throw Error(file + ": is empty; give a complete file");
  return lines;
}

double to_number(std::string_view text, const std::string& place, const std::string& what) {
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double value = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (failure != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
    const bool has_comma = text.find(',') != std::string_view::npos;
    throw Error(place + ": " + what + " is \"" + std::string(text) + "\"; it must be a number" +
                (has_comma ? ", with a point before its decimals and no comma" : ""));
  }
  return value;
}

std::vector<double> to_numbers(std::string_view text, const std::string& place,
                               const std::string& what) {
  std::vector<double> numbers;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find_first_of(kSpace), text.size());
    numbers.push_back(to_number(text.substr(0, end), place, what));
    text.remove_prefix(end);
  }
  return numbers;
}

}  // namespace xgm::dataset
