// SPDX-License-Identifier: Apache-2.0
// YAML to Node. Works on parser events rather than on yaml-cpp's own tree, because that tree hides
// duplicate keys, and shares aliased parts so that a short file can mean a huge one.
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "config/merge_keys.hpp"
#include "config/node.hpp"
#include "config/syntax_faults.hpp"
#include "config/utf8.hpp"

namespace xgm {
namespace {

// Far above any sensible pipeline; stops files made to exhaust the machine.
constexpr std::size_t kMaxNodes = 20000;
constexpr std::size_t kDeepest = 100;

// Thrown inside event handlers to leave the parser; becomes a diagnostic.
struct Fault {
  YAML::Mark mark;
  std::string message, remedy;
};

class Builder final : public YAML::EventHandler {
 public:
  explicit Builder(std::string file) : file_(std::move(file)) {}

  std::optional<Node> result() { return std::move(result_); }
  YAML::Mark begin() const { return begin_; }

  void OnDocumentStart(const YAML::Mark& mark) override { begin_ = mark; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(make(Node::Kind::null, mark), mark, anchor);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    require_no_tag(mark, tag);
    if (!is_utf8(value)) {
      throw Fault{mark, quote(value) + " is not in UTF-8", "save the file as UTF-8"};
    }
    Node node = make(Node::Kind::scalar, mark);
    node.scalar = value;
    node.quoted = tag == "!";
    const bool says_null = !node.quoted && (value == "~" || value == "null" || value.empty());
    if (says_null) node.kind = Node::Kind::null;
    add(std::move(node), mark, anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto known = anchors_.find(anchor);
    if (known == anchors_.end()) {
      throw Fault{mark, "this alias stands inside the very part that it repeats",
                  "write that part out"};
    }
    spend(count(known->second), mark);
    add(known->second, mark, 0);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    require_no_tag(mark, tag);
    open(make(Node::Kind::list, mark), mark, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    require_no_tag(mark, tag);
    open(make(Node::Kind::map, mark), mark, anchor);
  }
  void OnMapEnd() override {
    for (const Node& merged : open_.back().merged) merge(open_.back().node, merged);
    close();
  }

 private:
  struct Open {
    Node node;
    YAML::Mark begin;
    YAML::anchor_t anchor;
    std::optional<Entry> entry{};  // of a map: the key read, whose value comes next
    YAML::Mark key{};              // where it stands
    bool is_merge = false;         // whether it is the merge key
    std::vector<Node> merged{};    // maps whose entries stand in for those that this one lacks
  };

  static void require_no_tag(const YAML::Mark& mark, const std::string& tag) {
    const bool is_plain = tag.empty() || tag == "?" || tag == "!";
    if (is_plain || tag.starts_with("tag:yaml.org,2002:")) return;
    throw Fault{mark, "the tag " + quote(tag) + " has no meaning here", "write the value itself"};
  }

  Node make(Node::Kind kind, const YAML::Mark& mark) const {
    Node node;
    node.kind = kind;
    node.where = {file_, mark.line + 1, mark.column + 1};
    return node;
  }

  static std::size_t count(const Node& node) {
    std::size_t nodes = 1;
    for (const Node& item : node.items) nodes += count(item);
    for (const Entry& entry : node.entries) nodes += count(entry.value);
    return nodes;
  }

  void open(Node node, const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (open_.size() >= kDeepest) {
      throw Fault{mark, "nested too deeply", "a pipeline needs a few levels only"};
    }
    open_.push_back({std::move(node), mark, anchor});
  }

  void close() {
    Open done = std::move(open_.back());
    open_.pop_back();
    add(std::move(done.node), done.begin, done.anchor);
  }

  // What is kept to be repeated, and what repeats it, counts as well: it takes memory like the
  // rest.
  void spend(std::size_t nodes, const YAML::Mark& mark) {
    nodes_ += nodes;
    if (nodes_ > kMaxNodes) {
      throw Fault{mark, "more than 20000 values", "is this a pipeline file?"};
    }
  }

  // Puts a finished node where it belongs: into the innermost open list or map, or as the result.
  void add(Node node, const YAML::Mark& mark, YAML::anchor_t anchor) {
    spend(1, mark);
    if (anchor != 0) {
      spend(count(node), mark);
      anchors_[anchor] = node;
    }
    if (open_.empty()) {
      result_ = std::move(node);
      return;
    }
    Open& parent = open_.back();
    if (parent.node.is_list()) {
      parent.node.items.push_back(std::move(node));
    } else if (!parent.entry) {
      if (!node.is_scalar()) {
        throw Fault{mark, "a key must be a plain word, not " + spell(node), "write 'key: value'"};
      }
      parent.entry = Entry{node.scalar, node.where, {}};
      parent.key = mark;
      parent.is_merge = node.scalar == kMergeKey && !node.quoted;
    } else {
      parent.entry->value = std::move(node);
      finish_entry(parent);
    }
  }

  /// An entry whose value is there.
  static void finish_entry(Open& map) {
    Entry entry = std::move(*map.entry);
    map.entry.reset();
    if (!map.is_merge) {
      map.node.entries.push_back(std::move(entry));
      return;
    }
    if (!map.merged.empty()) {
      throw Fault{map.key, "key '<<' appears twice", "write one: '<<: [*FIRST, *SECOND]'"};
    }
    map.merged = maps_to_merge(std::move(entry.value));
    if (map.merged.empty()) {
      throw Fault{map.key, "'<<' merges maps, and this is none",
                  "write '<<: *NAME', or '<<: [*FIRST, *SECOND]', where &NAME marks a map"};
    }
  }

  std::string file_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, Node> anchors_;
  std::optional<Node> result_;
  YAML::Mark begin_;
  std::size_t nodes_ = 0;
};

/// Old systems end lines with CR alone.
std::string with_line_ends(std::string text) {
  if (text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');
  return text;
}

std::optional<Node> parse(const std::string& text, const std::string& name) {
  if (text.size() > kMaxYamlBytes) {
    throw Fault{YAML::Mark::null_mark(), "larger than 16 MB", "is this a pipeline file?"};
  }
  if (text.find('\0') != std::string::npos) {
    throw Fault{YAML::Mark::null_mark(), "holds zero bytes, as UTF-16 does", "save it as UTF-8"};
  }
  std::istringstream stream(with_line_ends(text));
  YAML::Parser parser(stream);
  Builder builder(name);
  if (!parser.HandleNextDocument(builder)) {
    Node nothing;
    nothing.where = {name};
    return nothing;
  }
  std::optional<Node> document = builder.result();
  Builder rest(name);
  if (parser.HandleNextDocument(rest)) {
    throw Fault{rest.begin(), "holds more than one document", "remove this '---' and what follows"};
  }
  return document;
}

}  // namespace

std::optional<Node> read_yaml(const std::string& text, const std::string& name,
                              Diagnostics& diagnostics) {
  const auto locate = [&](const YAML::Mark& mark) {
    return mark.is_null() ? Location{name} : Location{name, mark.line + 1, mark.column + 1};
  };
  try {
    return parse(text, name);
  } catch (const Fault& fault) {
    add_diagnostic(diagnostics, locate(fault.mark), fault.message, fault.remedy);
  } catch (const YAML::Exception& error) {
    diagnostics.push_back(explain_syntax(text, locate(error.mark), error.msg));
  }
  return std::nullopt;
}

}  // namespace xgm
