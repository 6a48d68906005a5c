// SPDX-License-Identifier: Apache-2.0
#include "config/utf8.hpp"

#include <bit>

namespace xgm {

bool is_utf8(std::string_view text) {
  int others = 0;  // bytes of the present character that are still to come
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const int ones = std::countl_one(byte);  // 0: a character of its own, 1: within one
    const bool is_other = ones == 1;
    if (is_other != (others > 0) || ones > 4) return false;
    others = is_other ? others - 1 : ones == 0 ? 0 : ones - 1;
  }
  return others == 0;
}

}  // namespace xgm
