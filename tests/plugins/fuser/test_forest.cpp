// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <fstream>

#include "plugins/fuser/candidate_features/features.hpp"
#include "plugins/fuser/forest/votes.hpp"
#include "tests/plugins/maps.hpp"
#include "tests/support/simd.hpp"
#include "tests/support/temporary_folder.hpp"

namespace xgm::testing {
namespace {

using forest::Forest;
using forest::Node;
using forest::Tree;

Tree random_tree(Random& random, int nodes, int features, int matchers) {
  Tree tree;
  for (int i = 0; i < nodes; ++i) {
    const auto child = [&] { return static_cast<std::uint16_t>(random.integer(i + 1, 2 * nodes)); };
    tree.nodes.push_back({static_cast<std::uint8_t>(random.integer(0, features - 1)),
                          static_cast<std::uint8_t>(random.integer(0, 255)), child(), child()});
  }
  for (int i = 0; i < (nodes + 1) * matchers; ++i) {
    tree.scores.push_back(static_cast<std::uint8_t>(random.integer(0, 255)));
  }
  return tree;
}

Forest random_forest(std::uint64_t seed, int matchers, int costs) {
  Random random(seed);
  const int features = fuser::FeatureLayout{matchers, costs}.count();
  Forest made{fuser::kFeatureVersion, matchers, costs, features, {}};
  for (const int nodes : {0, 1, 2, 40, 300}) {
    made.trees.push_back(random_tree(random, nodes, features, matchers));
  }
  return made;
}

void put(std::string& bytes, int value, int count) {
  for (; count > 0; --count, value /= 256) bytes += static_cast<char>(value % 256);
}

/// The format as forest_file.hpp describes it.
std::string file_of(const Forest& forest) {
  std::string bytes =
      "xgm forest 1\n# a comment\n#\nfeatures " + std::to_string(forest.feature_version) + " " +
      std::to_string(forest.matchers) + " " + std::to_string(forest.costs) + " " +
      std::to_string(forest.features) + "\ntrees " + std::to_string(forest.trees.size()) + "\n";
  for (const Tree& tree : forest.trees) {
    put(bytes, static_cast<int>(tree.nodes.size()), 2);
    for (const Node& node : tree.nodes) {
      put(bytes, node.feature, 1);
      put(bytes, node.threshold, 1);
      put(bytes, node.if_not, 2);
      put(bytes, node.if_so, 2);
    }
    bytes.append(tree.scores.begin(), tree.scores.end());
  }
  return bytes;
}

/// Walks down from a node, one step a call.
int naive_score(const Tree& tree, const std::uint8_t* features, std::size_t at, int matchers,
                int matcher) {
  if (at >= tree.nodes.size()) {
    return tree.scores.at((at - tree.nodes.size()) * static_cast<std::size_t>(matchers) +
                          static_cast<std::size_t>(matcher));
  }
  const Node& node = tree.nodes[at];
  const std::size_t next = features[node.feature] > node.threshold ? node.if_so : node.if_not;
  return naive_score(tree, features, next, matchers, matcher);
}

std::vector<std::uint8_t> random_features(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::uint8_t> features(count);
  for (auto& feature : features) feature = static_cast<std::uint8_t>(random.integer(0, 255));
  return features;
}

Candidates random_candidates(cv::Size size, std::size_t count) {
  Candidates candidates;
  for (std::size_t i = 0; i < count; ++i) {
    candidates.maps.push_back(random_map(size, {0, 6, 0.25, 0.2}, 20 + i));
  }
  candidates.others.resize(count);
  candidates.others.back() = random_map(size, {-6, 0, 0.25, 0.2}, 40);
  return candidates;
}

std::string saved(const TemporaryFolder& folder, const std::string& bytes) {
  const std::string path = folder / "model.forest";
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

std::shared_ptr<const Fuser> fuser_of(const std::string& path, const std::string& costs) {
  return stage<Fuser>("{type: forest, model: '" + path + "', costs: [" + costs + "]}");
}

TEST_CASE("votes of a forest are the scores at the leaves that a plain walk ends at") {
  const Forest forest = random_forest(1, 3, 1);
  for (const std::size_t pixels : {0U, 1U, 7U, 8U, 9U, 100U}) {
    const auto stride = static_cast<std::size_t>(forest.features);
    const std::vector<std::uint8_t> features = random_features(pixels * stride, pixels);
    const std::vector<int> votes = forest::votes(forest, features);
    REQUIRE(votes.size() == pixels * 3);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
      for (int matcher = 0; matcher < 3; ++matcher) {
        int sum = 0;
        for (const Tree& tree : forest.trees) {
          sum += naive_score(tree, features.data() + pixel * stride, 0, 3, matcher);
        }
        CHECK(votes[pixel * 3 + static_cast<std::size_t>(matcher)] == sum);
      }
    }
  }
}

TEST_CASE("a forest that is read is the one that was written") {
  const Forest forest = random_forest(2, 4, 2);
  const Forest read = forest::parse_forest(file_of(forest), "model.forest");
  CHECK(file_of(read) == file_of(forest));
}

TEST_CASE("a forest file that is cut or goes on is one error that names the file") {
  const std::string bytes = file_of(random_forest(3, 2, 0));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    CHECK_THROWS_WITH_AS(forest::parse_forest(bytes.substr(0, length), "model.forest"),
                         doctest::Contains("model.forest:"), Error);
  }
  CHECK_THROWS_WITH_AS(forest::parse_forest(bytes + "x", "model.forest"),
                       doctest::Contains("goes on after its last tree"), Error);
}

TEST_CASE("a forest file with any wrong byte is refused or safe to ask") {
  const std::string bytes = file_of(random_forest(4, 2, 0));
  int refused = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string wrong = bytes;
    wrong[i] = static_cast<char>(wrong[i] ^ 0x85);
    try {
      const Forest forest = forest::parse_forest(wrong, "model.forest");
      const auto features = random_features(static_cast<std::size_t>(forest.features), 5);
      CHECK(forest::votes(forest, features).size() == static_cast<std::size_t>(forest.matchers));
    } catch (const Error& error) {
      CHECK(error.message().find("model.forest:") == 0);
      ++refused;
    }
  }
  CHECK(refused > 0);
}

TEST_CASE("mistakes in a forest file are told with their place") {
  const auto told = [](const std::string& bytes) -> std::string {
    try {
      forest::parse_forest(bytes, "m");
    } catch (const Error& error) {
      return error.message();
    }
    return "nothing";
  };
  const std::string remedy = "; use a file that was written by train_forest.py";
  const std::string head = "xgm forest 1\nfeatures 1 1 0 13\ntrees 1\n";
  CHECK(told("P6\n") == "m:1: expected 'xgm forest' and 1 number" + remedy);
  CHECK(told("xgm forest 2\n") == "m:1: this version of the format is not known" + remedy);
  CHECK(told("xgm forest 1\n#\nfeatures 1 2\n") ==
        "m:3: expected 'features' and 4 numbers" + remedy);
  CHECK(told("xgm forest 1\nfeatures 1 0 0 9\n") ==
        "m:2: the number of matchers must be from 1 to 16" + remedy);
  CHECK(told(head + std::string("\x01\0\x0D\0\1\0\2\0\0\0", 10)) ==
        "m: byte 47: a node asks for a feature that there is not" + remedy);
  CHECK(told(head + std::string("\x01\0\0\0\0\0\2\0\0\0", 10)) ==
        "m: byte 47: a node comes after its child" + remedy);
  CHECK(told(head + std::string("\x01\0\0\0\1\0\3\0\0\0", 10)) ==
        "m: byte 47: a node has a child that there is not" + remedy);
}

TEST_CASE(
    "forest picks the disparity with the most votes where candidates differ, else the first") {
  const TemporaryFolder folder;
  const Forest model = random_forest(6, 3, 1);
  const std::string path = saved(folder, file_of(model));
  const cv::Size size(31, 22);
  const Candidates candidates = random_candidates(size, 3);
  const ImagePair pair = random_guide(size, 3, 8);
  with_each_simd_target([&] {
    const DisparityMap map = fuser_of(path, "census")->run(candidates, pair, Context{});
    CHECK(is_consistent(map));
    int disputed = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        std::vector<float> there;
        for (const DisparityMap& of : candidates.maps) {
          if (of.has_disparity(y, x)) there.push_back(of.disparity(y, x));
        }
        if (there.empty()) {
          CHECK(map.at(y, x) == candidates.maps.front().at(y, x));
          continue;
        }
        const auto [low, high] = std::minmax_element(there.begin(), there.end());
        const bool differ = *high - *low > 0.25F;
        disputed += differ ? 1 : 0;
        CHECK(map.disparity(y, x) >= *low);
        CHECK(map.disparity(y, x) <= *high);
        CHECK((map.confidence(y, x) == 1) == !differ);
      }
    }
    CHECK(disputed > 100);
  });
}

TEST_CASE("forest averages what is picked with what agrees with it, and with nothing else") {
  const TemporaryFolder folder;
  Forest model = random_forest(7, 3, 0);
  model.trees = {{{}, {200, 0, 10}}};  // always the first
  const std::string path = saved(folder, file_of(model));
  const Candidates candidates{{drawn_map({"222"}), drawn_map({"2.3"}), drawn_map({"352"})},
                              {{}, {}, {}}};
  const ImagePair pair = random_guide({3, 1}, 1, 9);
  const DisparityMap map = fuser_of(path, "")->run(candidates, pair, Context{});
  CHECK(map.disparity(0, 0) == doctest::Approx(7.0 / 3));
  CHECK(map.disparity(0, 1) == 2);
  CHECK(map.disparity(0, 2) == doctest::Approx(7.0 / 3));
  const auto none = stage<Fuser>("{type: forest, agreement: 0.5, model: '" + path + "'}");
  CHECK(identical(none->run(candidates, pair, Context{}), drawn_map({"222"})));
}

TEST_CASE("forest takes no matcher that has no disparity, whatever its votes") {
  const TemporaryFolder folder;
  Forest model = random_forest(7, 2, 0);
  model.trees = {{{}, {10, 200}}};  // always the second
  const auto fuser = fuser_of(saved(folder, file_of(model)), "");
  const Candidates candidates{{drawn_map({"11.."}), drawn_map({"5.5x"})}, {{}, {}}};
  const ImagePair pair = random_guide({4, 1}, 1, 9);
  CHECK(identical(fuser->run(candidates, pair, Context{}), drawn_map({"515."})));
}

TEST_CASE("forest refuses a model of other features, and another number of costs") {
  const TemporaryFolder folder;
  Forest model = random_forest(8, 2, 1);
  CHECK_THROWS_WITH_AS(fuser_of(saved(folder, file_of(model)), ""),
                       doctest::Contains("was trained with 1 costs; give as many, not 0"), Error);
  model.feature_version += 1;
  CHECK_THROWS_WITH_AS(fuser_of(saved(folder, file_of(model)), "census"),
                       doctest::Contains("was trained for other features"), Error);
  CHECK_THROWS_WITH_AS(fuser_of(folder / "missing.forest", "census"),
                       doctest::Contains("missing.forest: cannot be read"), Error);
}

}  // namespace
}  // namespace xgm::testing
