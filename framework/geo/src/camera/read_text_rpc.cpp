// SPDX-License-Identifier: Apache-2.0
#include <yaml-cpp/yaml.h>

#include <fstream>
#include <sstream>

#include "camera/rpc_fields.hpp"
#include "camera/rpc_formats.hpp"
#include "xgm/base/error.hpp"

namespace xgm::geo {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 24;

std::string read_text(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  for (char c = 0; text.size() < kMaxBytes && stream.get(c);) text += c;
  if (!stream.eof()) throw Error(file + ": cannot be read as the text of an RPC model");
  return text;
}

/// Adds every list and value of a dictionary, whatever it lies in: JSON is YAML too. Aliases can
/// make a small text endless: so many entries are read at most.
class Dictionary {
 public:
  Dictionary(const std::string& file, RpcFields& fields) : file_(file), fields_(fields) {}

  void add(const YAML::Node& node, int depth = 0) {
    if (!node.IsMap()) return;
    if (depth > kMaxDepth) throw Error(file_ + ": its dictionaries lie too deep in each other");
    for (const auto& entry : node) {
      if (++entries_ > kMaxEntries) throw Error(file_ + ": is too large for an RPC model");
      if (!entry.first.IsScalar()) continue;
      fields_.add(entry.first.Scalar(), text_of(entry.second));
      add(entry.second, depth + 1);
    }
  }

 private:
  static constexpr int kMaxDepth = 32;
  static constexpr int kMaxEntries = 10000;

  static std::string text_of(const YAML::Node& value) {
    if (value.IsScalar()) return value.Scalar();
    std::string text;
    if (value.IsSequence()) {
      for (const auto& item : value) text += item.IsScalar() ? item.Scalar() + " " : "nan ";
    }
    return text;
  }

  const std::string& file_;
  RpcFields& fields_;
  int entries_ = 0;
};

/// "KEY: value" or "key = value;" line by line. A list may go over several lines, in brackets.
void add_lines(const std::string& text, RpcFields& fields) {
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    const std::size_t end = line.find_first_of(":=");
    if (end == std::string::npos) continue;
    const std::size_t begin = line.find_first_not_of(" \t");
    const std::size_t last = line.find_last_not_of(" \t", end - 1);
    if (begin >= end) continue;
    std::string value = line.substr(end + 1), more = value;
    const bool is_list = value.find('(') != std::string::npos;
    while (is_list && more.find(')') == std::string::npos && std::getline(lines, more)) {
      value += more;
    }
    fields.add(std::string_view(line).substr(begin, last - begin + 1), value);
  }
}

}  // namespace

std::vector<RpcModel> read_text_rpc(const std::string& file) {
  const std::string text = read_text(file);
  RpcFields fields(file);
  const bool is_dictionary =
      file.ends_with("json") || file.ends_with("yaml") || file.ends_with("yml");
  if (is_dictionary) {
    try {
      Dictionary(file, fields).add(YAML::Load(text));
    } catch (const YAML::Exception& error) {
      throw Error(file + ": is no dictionary in YAML or JSON: " + error.what());
    }
  } else {
    add_lines(text, fields);
  }
  if (fields.empty()) throw Error(file + ": holds no RPC model");
  return {fields.model()};
}

}  // namespace xgm::geo
