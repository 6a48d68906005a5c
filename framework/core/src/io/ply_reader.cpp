// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iomanip>
#include <sstream>

#include "io/ply_values.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/scalar.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/ply.hpp"

namespace xgm {
namespace {

constexpr std::size_t kLongestHeader = std::size_t{1} << 20;
constexpr int kLongestNumber = 64;  // characters; what is longer is none

std::vector<std::string> words_of(std::string_view line) {
  std::istringstream stream{std::string(line)};
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::size_t record_size(const PlyHeader& header) {
  std::size_t bytes = 0;
  for (const PlyProperty& property : header.properties) bytes += size_of(property.type);
  return bytes;
}

/// The text behind the first word.
std::string rest_of(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t", line.find_first_of(" \t"));
  return begin == std::string_view::npos ? std::string() : std::string(line.substr(begin));
}

}  // namespace

PlyReader::PlyReader(const std::string& file) : file_(file) {
  const std::string head = read_head(file, kLongestHeader);
  if (!head.starts_with("ply\n") && !head.starts_with("ply\r\n")) fail(": is no PLY file");
  constexpr std::string_view kEnd = "\nend_header";
  const std::size_t last_line = head.find(kEnd);
  const std::size_t end =
      last_line == std::string::npos ? last_line : head.find('\n', last_line + kEnd.size());
  if (end == std::string::npos) fail(": its header does not end; it is cut off or no PLY file");
  read_header(std::string_view(head).substr(0, last_line));
  std::error_code failure;
  const std::uint64_t bytes = std::filesystem::file_size(file, failure);
  if (failure) fail(": cannot be read: " + failure.message());
  require_body(bytes - (end + 1));
  stream_.open(file, std::ios::binary);
  stream_.seekg(static_cast<std::streamoff>(end + 1));
  if (!stream_) fail(": cannot be read");
}

void PlyReader::fail(const std::string& what) const { throw Error(file_ + what); }

void PlyReader::read_header(std::string_view text) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    while (line.ends_with('\r')) line.remove_suffix(1);
    if (number > 1) read_line(line, number);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!has_format_) fail(": its header says no format");
  if (!has_vertices_) fail(": its header says nothing of vertices");
  if (header_.properties.empty()) fail(": its vertices have no properties");
}

void PlyReader::read_line(std::string_view line, std::size_t number) {
  const std::string place = ":" + std::to_string(number) + ": ";
  const std::vector<std::string> words = words_of(line);
  if (words.empty() || words[0] == "obj_info") return;
  if (words[0] == "comment") {
    header_.comments.push_back(rest_of(line));
  } else if (words[0] == "format" && words.size() == 3) {
    is_ascii_ = words[1] == "ascii";
    has_format_ = true;
    if (!is_ascii_ && words[1] != "binary_little_endian") {
      fail(place + "format " + words[1] + " is not read; convert it to binary_little_endian");
    }
  } else if (words[0] == "element" && words.size() == 3) {
    const auto count = to_number<std::uint64_t>(words[2]);
    if (!count) fail(place + "'" + words[2] + "' is no number of elements");
    if (!has_vertices_ && words[1] != "vertex") {
      fail(place + "the first element is '" + words[1] + "'; vertices must come first");
    }
    in_vertices_ = !has_vertices_;
    has_vertices_ = true;
    if (in_vertices_) header_.count = *count;
  } else if (words[0] == "property" && has_vertices_) {
    if (in_vertices_) add_property(words, place);
  } else {
    fail(place + "this line of the header is not understood");
  }
}

void PlyReader::add_property(const std::vector<std::string>& words, const std::string& place) {
  if (words.size() != 3) fail(place + "expected 'property TYPE NAME'; lists are not read");
  const auto type = ply_type(words[1]);
  if (!type) fail(place + "'" + words[1] + "' is no type of PLY");
  for (const PlyProperty& other : header_.properties) {
    if (other.name == words[2]) fail(place + "there is another property '" + words[2] + "'");
  }
  header_.properties.push_back({words[2], *type});
}

void PlyReader::require_body(std::uint64_t bytes) const {
  // A number of a text and what parts it from the next one are two characters.
  const std::uint64_t least =
      is_ascii_ ? 2 * header_.properties.size() : std::uint64_t{record_size(header_)};
  const std::uint64_t there = (is_ascii_ ? bytes + 1 : bytes) / least;
  if (header_.count <= there) return;
  fail(": its header announces " + std::to_string(header_.count) + " points, but at most " +
       std::to_string(there) + " are there; it is cut off");
}

bool PlyReader::next(std::span<double> values) {
  if (read_ == header_.count) return false;
  const std::string place = ": point " + std::to_string(read_ + 1) + ": ";
  for (std::size_t i = 0; i < header_.properties.size(); ++i) {
    const PlyProperty& property = header_.properties[i];
    if (is_ascii_) {
      std::string word;
      if (!(stream_ >> std::setw(kLongestNumber) >> word)) {
        fail(place + "is missing; the file is cut off");
      }
      const auto value = to_number<double>(word);
      if (!value) fail(place + "'" + word + "' is no number");
      values[i] = *value;
    } else {
      char bytes[sizeof(double)];
      if (!stream_.read(bytes, static_cast<std::streamsize>(size_of(property.type)))) {
        fail(place + "cannot be read");
      }
      values[i] = load(bytes, property.type);
    }
  }
  ++read_;
  return true;
}

}  // namespace xgm
