// SPDX-License-Identifier: Apache-2.0
// What a program prints, as lines of the log.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "xgm/stage/context.hpp"

namespace xgm::exchange {

class Printed {
 public:
  explicit Printed(const Context& context) : context_(context) {}

  /// The next bytes. Ends of lines may be of any system; bars that are drawn over themselves are
  /// lines, too.
  void take(std::string_view bytes);
  /// There will be no more.
  void finish();

  std::size_t bytes() const { return bytes_; }
  /// The last line that is not blank; empty if there is none.
  const std::string& last() const { return last_; }

 private:
  void end_line();

  const Context& context_;
  std::string line_, last_;
  std::size_t lines_ = 0, bytes_ = 0;
};

}  // namespace xgm::exchange
