// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <atomic>
#include <filesystem>
#include <thread>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/pipeline/question.hpp"
#include "xgm/pipeline/result_cache.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::identical;
using xgm::testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kRoomy = 1'000'000'000;
const Json kQuestion = {{"left", "a1"}};

DisparityMap map_of(int value) {
  DisparityMap map({40, 30}, Status::occluded);
  map.set(3, 4, static_cast<float>(value));
  return map;
}

struct Desk : TemporaryFolder {
  std::string folder = *this / "cache";
  std::vector<std::string> told{};

  ResultCache cache(std::uint64_t bytes = kRoomy, const Json& question = kQuestion) {
    return ResultCache(folder, bytes, question, [this](const auto& text) { told.push_back(text); });
  }
  std::uint64_t bytes() const {
    std::uint64_t sum = 0;
    for (const auto& entry : fs::directory_iterator(folder)) sum += entry.file_size();
    return sum;
  }
  /// As if so many hours had passed.
  void age(int hours) const {
    for (const auto& entry : fs::directory_iterator(folder)) {
      fs::last_write_time(entry, entry.last_write_time() - std::chrono::hours(hours));
    }
  }
};

}  // namespace

TEST_CASE("a cache gives other runs of the same question what one has found") {
  Desk desk;
  desk.cache().keep("matcher", {map_of(1), map_of(2)});
  ResultCache same = desk.cache();
  const auto found = same.find("matcher");
  REQUIRE(found.has_value());
  CHECK(identical(found->forward, map_of(1)));
  CHECK(identical(found->reverse.value(), map_of(2)));
  CHECK(same.reused() == std::vector<std::string>{"matcher"});
  CHECK_FALSE(desk.cache(kRoomy, {{"left", "b2"}}).find("matcher").has_value());
  ResultCache parts = desk.cache();
  parts.of_part("tile_1_1")->keep("matcher", {map_of(3), {}});
  CHECK(identical(parts.of_part("tile_1_1")->find("matcher")->forward, map_of(3)));
  CHECK_FALSE(parts.of_part("tile_1_2")->find("matcher").has_value());
  CHECK(identical(parts.find("matcher")->forward, map_of(1)));
}

TEST_CASE("a cache holds what it may, and gives up first what was not used for the longest time") {
  Desk desk;
  desk.cache().keep("a", {map_of(1), {}});
  const std::uint64_t one = desk.bytes();
  const std::uint64_t limit = 3 * one + one / 2;
  for (const char* name : {"b", "c"}) {
    desk.age(1);
    desk.cache(limit).keep(name, {map_of(2), {}});
  }
  desk.age(1);
  CHECK(desk.cache(limit).find("a").has_value());  // used again
  desk.cache(limit).keep("d", {map_of(3), {}});
  CHECK(desk.bytes() <= limit);
  for (const std::string name : {"a", "b", "c", "d"}) {
    CAPTURE(name);
    CHECK(desk.cache().find(name).has_value() == (name != "b"));
  }
  desk.write("cache/notes.txt", std::string(10000, 'x'));
  desk.cache(one / 2).keep("e", {map_of(3), {}});
  CHECK(fs::exists(desk.folder + "/notes.txt"));
  CHECK(desk.files() == 1);
  CHECK(desk.bytes() == 10000);
  CHECK(desk.told.empty());
}

TEST_CASE("what is damaged in a cache is told of, removed and made again") {
  Desk desk;
  desk.cache().keep("a", {map_of(1), {}});
  for (const auto& entry : fs::directory_iterator(desk.folder)) {
    if (entry.path().extension() != ".pfm") continue;
    const std::string bytes = read_file(entry.path().string());
    write_file(entry.path().string(), bytes.substr(0, bytes.size() / 2));
  }
  CHECK_FALSE(desk.cache().find("a").has_value());
  REQUIRE(desk.told.size() == 1);
  CHECK_FALSE(desk.cache().find("a").has_value());
  CHECK(desk.told.size() == 1);
  desk.cache().keep("a", {map_of(1), {}});
  CHECK(desk.cache().find("a").has_value());
}

TEST_CASE("a cache that cannot be written to fails no run; one that cannot be made is refused") {
  Desk desk;
  ResultCache cache = desk.cache();
  fs::remove_all(desk.folder);
  desk.write("cache", "a file");
  cache.keep("a", {map_of(1), {}});
  cache.keep("b", {map_of(1), {}});
  REQUIRE(desk.told.size() == 1);
  CHECK(contains(desk.told[0], "nothing more is kept"));
  CHECK(contains(error_of([&] { desk.cache(); }), "--cache "));
}

TEST_CASE("runs side by side in a cache that is too small for them find right results or none") {
  Desk desk;
  desk.cache().keep("0", {map_of(0), {}});
  const std::uint64_t limit = 3 * desk.bytes();
  std::atomic<int> wrong = 0, found = 0;
  const auto work = [&](int first) {
    ResultCache cache(desk.folder, limit, kQuestion, [](const auto&) {});
    for (int i = 0; i < 60; ++i) {
      const int value = (first + i) % 5;
      if (const auto result = cache.find(std::to_string(value))) {
        ++found;
        if (!identical(result->forward, map_of(value))) ++wrong;
      } else {
        cache.keep(std::to_string(value), {map_of(value), {}});
      }
    }
  };
  std::thread other(work, 2);
  work(0);
  other.join();
  CHECK(wrong == 0);
  CHECK(found > 0);
}
