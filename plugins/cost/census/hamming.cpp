// SPDX-License-Identifier: Apache-2.0
// Hamming distances, one instance per number of words so that the inner loop has no branches.
#include "plugins/cost/census/hamming.hpp"

#include <array>
#include <bit>

namespace xgm::census {
namespace {

template <int kChannels, std::size_t kWords>
void distances(const Descriptors& base, const Descriptors& match, const cost::Candidates& c) {
  std::array<std::uint64_t, kWords> own{};
  std::array<const std::uint64_t*, kWords> others{};
  for (std::size_t k = 0; k < kWords; ++k) {
    own[k] = base.word(static_cast<int>(k))[c.x];
    others[k] = match.word(static_cast<int>(k)) + c.first;
  }
  for (int i = 0; i < c.count; ++i) {
    int bits = 0;
    for (std::size_t k = 0; k < kWords; ++k) bits += std::popcount(own[k] ^ others[k][i]);
    c.cells[i] = static_cast<std::uint8_t>((2 * bits + kChannels) / (2 * kChannels));
  }
}

}  // namespace

void hamming(const Descriptors& base, const Descriptors& mirrored_match,
             const cost::Candidates& c) {
  using Kernel = void (*)(const Descriptors&, const Descriptors&, const cost::Candidates&);
  static constexpr std::array<Kernel, 4> kGrey{distances<1, 1>, distances<1, 2>, distances<1, 3>,
                                               distances<1, 4>};
  static constexpr std::array<Kernel, 4> kColour{distances<3, 1>, distances<3, 2>, distances<3, 3>,
                                                 distances<3, 4>};
  const auto& kernels = base.channels == 1 ? kGrey : kColour;
  kernels[static_cast<std::size_t>(base.word_count - 1)](base, mirrored_match, c);
}

}  // namespace xgm::census
