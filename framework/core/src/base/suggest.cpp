// SPDX-License-Identifier: Apache-2.0
#include "xgm/base/suggest.hpp"

#include <algorithm>
#include <cctype>

namespace xgm {
namespace {

bool same_letter(char a, char b) {
  const auto fold = [](char c) {
    return c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  };
  return fold(a) == fold(b);
}

// Edit distance with swaps of neighbours (optimal string alignment): single typing slips cost 1.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      const std::size_t change = same_letter(a[i - 1], b[j - 1]) ? 0 : 1;
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + change});
      const bool swapped =
          i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]);
      if (swapped) cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
    }
  }
  return cost[a.size()][b.size()];
}

}  // namespace

std::string join(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string closest(std::string_view written, const std::vector<std::string>& names) {
  constexpr std::size_t kLongestName = 64;
  const std::string* best = nullptr;
  std::size_t minimum = std::max<std::size_t>(1, std::min<std::size_t>(3, written.size() / 2)) + 1;
  for (const std::string& name : names) {
    if (written.size() > kLongestName) break;
    const std::size_t d = distance(written, name);
    if (d < minimum) {
      minimum = d;
      best = &name;
    }
  }
  return best == nullptr ? std::string() : *best;
}

std::string suggest(std::string_view written, const std::vector<std::string>& names,
                    const std::string& label) {
  const std::string meant = closest(written, names);
  if (!meant.empty()) return "did you mean '" + meant + "'?";
  return names.empty() ? std::string() : label + ": " + join(names);
}

}  // namespace xgm
