// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/file_layouts/text_file.hpp"

#include <charconv>
#include <cmath>
#include <fstream>

#include "xgm/base/error.hpp"

namespace xgm::dataset {
namespace {

constexpr std::size_t kMaxBytes = 1 << 16;
constexpr std::string_view kSpace = " \t\r\n";

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
    throw Error(file + ": cannot be read; check the permissions");
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > kMaxBytes) {
    throw Error(file + ": larger than 64 KB, which no such file is; check what it is");
  }
  std::vector<Line> lines;
  std::size_t begin = 0;
  for (int number = 1; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = trimmed(std::string_view(text).substr(begin, end - begin));
    if (!line.empty()) lines.push_back({file + ":" + std::to_string(number), std::string(line)});
    begin = end + 1;
  }
  return lines;
}

double to_number(std::string_view text, const std::string& place, const std::string& what) {
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double value = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (failure != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
    throw Error(place + ": " + what + " is \"" + std::string(text) + "\"; it must be a number");
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
