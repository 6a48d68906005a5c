// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <regex>
#include <sstream>

#include "architecture/rules.hpp"

namespace xgm::architecture {
namespace {

constexpr auto kMaxFileLines = 400;
constexpr int kMaxFunctionLines = 60;

struct Function {
  int first_line = 0;
  int lines = 0;
  std::string signature;
};

/// Finds the definitions in text as clang-format lays it out: a definition begins where a
/// declaration may stand, its signature ends with '{', and the brace that closes it is indented as
/// its first line is. Namespaces, classes and tables are looked into; lambdas and control
/// statements are parts of the function around them.
class FunctionFinder {
 public:
  std::vector<Function> run(const std::string& text) {
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) read(line, ++number);
    return found_;
  }

 private:
  void read(const std::string& line, int number) {
    const std::size_t indentation = std::min(line.find_first_not_of(' '), line.size());
    const std::string text =
        line.substr(indentation, line.find("  // ", indentation) - indentation);
    if (inside_)
      read_body(text, indentation, number);
    else
      read_declaration(text, indentation, number);
  }

  void read_body(const std::string& text, std::size_t indentation, int number) {
    // "} catch (...) {" goes on with the function.
    if (!text.starts_with("}") || indentation != indentation_ || text.ends_with("{")) return;
    current_.lines = number - current_.first_line + 1;
    found_.push_back(current_);
    current_ = {};
    inside_ = false;
  }

  void read_declaration(const std::string& text, std::size_t indentation, int number) {
    static const std::regex between(R"(^$|^//|^#|^\}|^(public|private|protected):)");
    if (std::regex_search(text, between)) {
      current_ = {};
      return;
    }
    if (current_.signature.empty()) {
      current_.first_line = number;
      indentation_ = indentation;
    }
    current_.signature += (current_.signature.empty() ? "" : " ") + text;
    if (text.ends_with("{")) {
      inside_ = opens_function(current_.signature);
      if (!inside_) current_ = {};
    } else if (text.ends_with(";") || text.ends_with("}")) {
      current_ = {};
    }
  }

  static bool opens_function(const std::string& signature) {
    static const std::regex scope(
        R"(^(template <.*> )?(inline )?(namespace|class|struct|union|enum|extern "C")\b)");
    static const std::regex table(R"([=(,{]\s*\{$)");
    return signature.find('(') != std::string::npos && !std::regex_search(signature, scope) &&
           !std::regex_search(signature, table);
  }

  std::vector<Function> found_;
  Function current_;
  std::size_t indentation_ = 0;
  bool inside_ = false;
};

bool is_cpp(const std::string& file) { return file.ends_with(".cpp") || file.ends_with(".hpp"); }

}  // namespace

Violations long_files(const Tree& tree) {
  Violations violations;
  for (const auto& [file, text] : tree) {
    const auto lines = std::count(text.begin(), text.end(), '\n');
    if (lines > kMaxFileLines)
      violations.push_back(file + " has " + std::to_string(lines) + " lines");
  }
  return violations;
}

Violations long_functions(const Tree& tree) {
  Violations violations;
  for (const auto& [file, text] : tree) {
    if (!is_cpp(file)) continue;
    for (const Function& function : FunctionFinder().run(text))
      if (function.lines > kMaxFunctionLines)
        violations.push_back(file + ":" + std::to_string(function.first_line) + ": '" +
                             function.signature + "' has " + std::to_string(function.lines) +
                             " lines");
  }
  return violations;
}

}  // namespace xgm::architecture
