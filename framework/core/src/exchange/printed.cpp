// SPDX-License-Identifier: Apache-2.0
#include "exchange/printed.hpp"

#include <utility>

namespace xgm::exchange {
namespace {

constexpr std::size_t kLines = 200;   // that the log takes; the others are counted
constexpr std::size_t kLength = 500;  // bytes of a line

}  // namespace

void Printed::take(std::string_view bytes) {
  bytes_ += bytes.size();
  for (const char c : bytes) {
    if (c == '\n' || c == '\r') {
      end_line();
    } else if (line_.size() < kLength) {
      line_ += static_cast<unsigned char>(c) < ' ' ? ' ' : c;  // what would move the cursor
    }
  }
}

void Printed::end_line() {
  const std::string line = std::exchange(line_, {});
  if (line.find_first_not_of(' ') == std::string::npos) return;
  last_ = line;
  if (++lines_ <= kLines) context_.info(line);
}

void Printed::finish() {
  end_line();
  if (lines_ <= kLines) return;
  context_.warn("the program printed " + std::to_string(lines_) + " lines; the log has the first " +
                std::to_string(kLines));
}

}  // namespace xgm::exchange
