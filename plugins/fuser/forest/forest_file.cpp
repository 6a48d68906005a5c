// SPDX-License-Identifier: Apache-2.0
#include "plugins/fuser/forest/forest_file.hpp"

#include <charconv>
#include <fstream>
#include <sstream>

#include "xgm/base/error.hpp"

namespace xgm::forest {
namespace {

constexpr int kMaxTrees = 1024;
constexpr int kMaxMatchers = 16;
constexpr int kMaxFeatures = 256;  // a node tells its feature in a byte

/// Reads from the front; every read is checked.
class Reader {
 public:
  Reader(std::string_view bytes, const std::string& path) : bytes_(bytes), path_(path) {}

  std::size_t position() const { return position_; }
  std::size_t left() const { return bytes_.size() - position_; }

  std::string_view line() {
    const std::size_t end = bytes_.find('\n', position_);
    ++line_;
    if (end == std::string_view::npos) fail_in_line("the file ends within its header");
    const std::string_view text = bytes_.substr(position_, end - position_);
    position_ = end + 1;
    return text;
  }
  int byte() {
    if (left() < 1) fail("the file ends within a tree");
    return static_cast<unsigned char>(bytes_[position_++]);
  }
  int two_bytes() {
    const int low = byte();
    return low + 256 * byte();
  }
  [[noreturn]] void fail_in_line(const std::string& what) const {
    throw Error(path_ + ":" + std::to_string(line_) + ": " + what + kRemedy);
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(path_ + ": byte " + std::to_string(position_) + ": " + what + kRemedy);
  }

 private:
  static constexpr const char* kRemedy = "; use a file that was written by train_forest.py";
  std::string_view bytes_;
  const std::string& path_;
  std::size_t position_ = 0;
  int line_ = 0;
};

/// The numbers of "word 1 2 3".
std::vector<int> numbers_of(Reader& reader, std::string_view word, std::size_t count) {
  std::string_view text = reader.line();
  while (text.starts_with('#')) text = reader.line();
  const std::string form = "expected '" + std::string(word) + "' and " + std::to_string(count) +
                           (count == 1 ? " number" : " numbers");
  if (!text.starts_with(word)) reader.fail_in_line(form);
  const char* at = text.data() + word.size();
  const char* const end = text.data() + text.size();
  std::vector<int> numbers(count);
  for (int& number : numbers) {
    if (at == end || *at != ' ') reader.fail_in_line(form);
    const auto [next, error] = std::from_chars(at + 1, end, number);
    if (error != std::errc()) reader.fail_in_line(form);
    at = next;
  }
  if (at != end) reader.fail_in_line(form);
  return numbers;
}

Forest header_of(Reader& reader) {
  if (numbers_of(reader, "xgm forest", 1)[0] != 1) {
    reader.fail_in_line("this version of the format is not known");
  }
  const std::vector<int> features = numbers_of(reader, "features", 4);
  Forest forest{features[0], features[1], features[2], features[3], {}};
  const auto within = [&](int value, int low, int high, const char* what) {
    if (value >= low && value <= high) return;
    reader.fail_in_line(std::string(what) + " must be from " + std::to_string(low) + " to " +
                        std::to_string(high));
  };
  within(forest.matchers, 1, kMaxMatchers, "the number of matchers");
  within(forest.costs, 0, kMaxFeatures, "the number of costs");
  within(forest.features, 1, kMaxFeatures, "the number of features");
  const int trees = numbers_of(reader, "trees", 1)[0];
  within(trees, 1, kMaxTrees, "the number of trees");
  forest.trees.resize(static_cast<std::size_t>(trees));
  return forest;
}

Node node_of(Reader& reader, int index, int nodes, int features) {
  const int feature = reader.byte(), threshold = reader.byte();
  const int if_not = reader.two_bytes(), if_so = reader.two_bytes();
  if (feature >= features) reader.fail("a node asks for a feature that there is not");
  for (const int child : {if_not, if_so}) {
    if (child <= index) reader.fail("a node comes after its child");
    if (child > 2 * nodes) reader.fail("a node has a child that there is not");
  }
  return {static_cast<std::uint8_t>(feature), static_cast<std::uint8_t>(threshold),
          static_cast<std::uint16_t>(if_not), static_cast<std::uint16_t>(if_so)};
}

Tree tree_of(Reader& reader, const Forest& forest) {
  const int nodes = reader.two_bytes();
  if (2 * nodes > 0xFFFF) reader.fail("a tree has more nodes than its children can be told in");
  const auto leaves = static_cast<std::size_t>(nodes + 1);
  const std::size_t scores = leaves * static_cast<std::size_t>(forest.matchers);
  if (reader.left() < static_cast<std::size_t>(nodes) * 6 + scores) {
    reader.fail("the file ends within a tree");
  }
  Tree tree;
  for (int i = 0; i < nodes; ++i) {
    tree.nodes.push_back(node_of(reader, i, nodes, forest.features));
  }
  for (std::size_t i = 0; i < scores; ++i) {
    tree.scores.push_back(static_cast<std::uint8_t>(reader.byte()));
  }
  return tree;
}

}  // namespace

Forest parse_forest(std::string_view bytes, const std::string& path) {
  Reader reader(bytes, path);
  Forest forest = header_of(reader);
  for (Tree& tree : forest.trees) tree = tree_of(reader, forest);
  if (reader.left() > 0) reader.fail("the file goes on after its last tree");
  return forest;
}

Forest read_forest(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  if (!file || !bytes) throw Error(path + ": cannot be read; give the file of a forest");
  return parse_forest(bytes.view(), path);
}

}  // namespace xgm::forest
