// SPDX-License-Identifier: Apache-2.0
// Files of forests: what is accepted can be asked about any pixel.
#include "plugins/fuser/forest/votes.hpp"

#include "fuzz/support/target.hpp"

namespace xgm::fuzz {

void check(std::string_view input) {
  forest::Forest read;
  if (!accepts("forest:", [&] { read = forest::parse_forest(input, "forest"); })) return;
  for (const int level : {0, 127, 255}) {
    const std::vector<std::uint8_t> features(static_cast<std::size_t>(read.features) * 9,
                                             static_cast<std::uint8_t>(level));
    const std::vector<int> votes = forest::votes(read, features);
    require(votes.size() == static_cast<std::size_t>(read.matchers) * 9, "all matchers have votes");
    for (const int vote : votes) {
      require(vote >= 0 && vote <= 255 * static_cast<int>(read.trees.size()),
              "votes are sums of scores");
    }
  }
}

std::vector<std::string> seeds() {
  using std::string_literals::operator""s;
  return {"xgm forest 1\n# comment\nfeatures 1 2 0 3\ntrees 1\n\0\0\x07\x09"s,
          "xgm forest 1\nfeatures 1 1 0 3\ntrees 2\n\x01\0\x02\x80\x01\0\x02\0\x10\x20\0\0\x05"s};
}

std::vector<std::string> words() { return {"xgm forest 1\n", "features ", "trees ", "# ", " 255"}; }

}  // namespace xgm::fuzz
