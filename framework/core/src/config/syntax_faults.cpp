// SPDX-License-Identifier: Apache-2.0
#include "config/syntax_faults.hpp"

#include <optional>
#include <string_view>

namespace xgm {
namespace {

struct Explanation {
  std::string_view message;  ///< begin of the parser's
  const char* remedy;
};

constexpr Explanation kExplanations[] = {
    {"end of map not found",
     "indent this line as those that it belongs to, and write 'key: value'"},
    {"end of sequence not found", "indent this line as those that it belongs to, and write '- '"},
    {"end of map flow not found",
     "close the '{' before this place, or put a comma between entries"},
    {"end of sequence flow not found",
     "close the '[' before this place, or put a comma between elements"},
    {"illegal map value",
     "write 'key: value' with a blank behind the colon, in this line and in the one before, and "
     "put "
     "text that holds a colon in quotes"},
    {"illegal EOF in scalar", "close the quotes"},
    {"the referenced anchor is not defined", "mark what is to be repeated by &NAME, further up"},
    {"unknown token", "put text that begins with such a character in quotes"},
    {"unknown escape character", "use single quotes, in which a backslash is a backslash"}};

constexpr const char* kUsualRemedy = "look at the indentation and at brackets and quotes left open";

/// A character that looks like blanks and does not count as such.
struct FalseBlank {
  std::string_view bytes;
  const char* name;
};

constexpr FalseBlank kFalseBlanks[] = {{"\t", "a tab"}, {"\xC2\xA0", "a no-break space"}};

/// The first false blank in the indentation of a line, as far as `last_line`.
std::optional<Diagnostic> find_false_blank(std::string_view text, const Location& where) {
  std::size_t begin = 0;
  for (int line = 1; line <= where.line && begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view content = text.substr(begin, end - begin);
    const std::size_t first = std::min(content.find_first_not_of(' '), content.size());
    for (const FalseBlank& blank : kFalseBlanks) {
      if (!content.substr(first).starts_with(blank.bytes)) continue;
      return Diagnostic{{where.file, line, static_cast<int>(first) + 1},
                        std::string(blank.name) + " indents this line",
                        "YAML is indented by blanks only; replace it"};
    }
    begin = end + 1;
  }
  return std::nullopt;
}

}  // namespace

Diagnostic explain_syntax(const std::string& text, const Location& where,
                          const std::string& message) {
  if (auto blank = find_false_blank(text, where)) return *blank;
  const char* remedy = kUsualRemedy;
  for (const Explanation& known : kExplanations) {
    if (message.starts_with(known.message)) remedy = known.remedy;
  }
  return {where, "not valid YAML: " + message, remedy};
}

}  // namespace xgm
