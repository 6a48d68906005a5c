// SPDX-License-Identifier: Apache-2.0
// Penalties are looked at when an aggregation asks for them.
#include "framework/stage/doing.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

/// Penalties of one table, of which every pixel has the same class.
class OneTable final : public PenaltyField {
 public:
  explicit OneTable(PenaltyTable table, std::uint8_t pixel_class = 0)
      : table_(std::move(table)), class_(pixel_class) {}
  PenaltyTable table(Direction) const override { return table_; }
  void classify(Direction, int y, std::span<std::uint8_t> base,
                std::span<std::uint8_t> match) const override {
    std::ranges::fill(base, y == 3 ? class_ : std::uint8_t{0});
    std::ranges::fill(match, std::uint8_t{0});
  }

 private:
  PenaltyTable table_;
  std::uint8_t class_;
};

/// What an aggregation ends with that is given such penalties.
std::string error_with(const OneTable& field) {
  const ImagePair pair = shifted_pair({16, 9}, 1, 1);
  const auto slot =
      slot_of<DoingPenalty>([&](auto&&...) { return std::make_unique<const OneTable>(field); });
  CostVolume costs(
      std::make_shared<const VolumeShape>(DisparityRange::uniform(pair.size(), {0, 4})), 20);
  std::fill_n(costs.data(), costs.bytes(), std::uint8_t{1});
  return error_of([&] {
    const auto penalties = slot(Context(), pair);
    stage<Aggregation>("sgm")->run(costs, *penalties, Context());
  });
}

std::string faulty(const std::string& rule) {
  return "here: penalty 'bad' returned a faulty result: " + rule +
         "; correct the plugin, or use another one";
}

}  // namespace

TEST_CASE("penalties that are none are told") {
  const ImagePair pair = shifted_pair({4, 4}, 1, 1);
  const auto slot = slot_of<DoingPenalty>([](auto&&...) { return nullptr; });
  CHECK(error_of([&] { slot(Context(), pair); }) == faulty("there is no penalty field"));
}

TEST_CASE("tables and classes of penalties are told before an aggregation reads beyond them") {
  CHECK(error_with(OneTable({2, 1, {{1, 2}, {3, 4}}}, 1)) == "");
  CHECK(error_with(OneTable({2, 1, {{1, 2}, {3, 4}}}, 2)) ==
        faulty("a class is not in the table (x 0, y 3)"));
  CHECK(error_with(OneTable({2, 2, {{1, 2}, {3, 4}}})) ==
        faulty("the table does not have an entry for each pair of classes"));
  CHECK(error_with(OneTable({0, 1, {}})) == faulty("the number of classes is not in 1 to 256"));
  CHECK(error_with(OneTable({1, 1, {{5, 4}}})) == faulty("not 0 <= p1 <= p2"));
  CHECK(error_with(OneTable({1, 1, {{-1, 4}}})) == faulty("not 0 <= p1 <= p2"));
}
