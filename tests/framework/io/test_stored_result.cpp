// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/stored_map.hpp"
#include "xgm/io/stored_result.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::identical;
using xgm::testing::TemporaryFolder;

namespace {

DisparityMap some_map(float value) {
  DisparityMap map({37, 23}, Status::occluded);
  map.set(3, 4, -12.3456789F * value);
  map.set(5, 6, 0.1F, Status::filled);
  return map;
}

MatchResult some_result() {
  MatchResult result{some_map(1), some_map(2)};
  result.forward.confidence = cv::Mat1f(23, 37, 0.25F);
  result.forward.confidence(7, 8) = NAN;
  return result;
}

bool same_confidence(const DisparityMap& a, const DisparityMap& b) {
  if (a.confidence.size() != b.confidence.size()) return false;
  return std::equal(a.confidence.begin(), a.confidence.end(), b.confidence.begin(),
                    [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

}  // namespace

TEST_CASE("stored maps come back to the last bit, and are refused if they do not fit") {
  const TemporaryFolder folder;
  const DisparityMap map = some_map(1);
  write_stored_map(folder.path(), "a", map);
  CHECK(identical(read_stored_map(folder.path(), "a"), map));
  write_png(folder / "a_status.png", cv::Mat1b(23, 37, std::uint8_t{200}));
  CHECK(
      contains(error_of([&] { read_stored_map(folder.path(), "a"); }), "does not hold the status"));
  write_png(folder / "a_status.png", cv::Mat1b(23, 36, std::uint8_t{0}));
  CHECK(
      contains(error_of([&] { read_stored_map(folder.path(), "a"); }), "does not hold the status"));
}

TEST_CASE("stored results come back with both views and the confidence, also over earlier ones") {
  const TemporaryFolder folder;
  const MatchResult both = some_result();
  CHECK(state_of_result(folder.path(), "a", "q") == StoredState::missing);
  write_result(folder.path(), "a", "q", both);
  CHECK(state_of_result(folder.path(), "a", "q") == StoredState::complete);
  CHECK(state_of_result(folder.path(), "a", "p") == StoredState::missing);
  const MatchResult read = read_result(folder.path(), "a");
  CHECK(identical(read.forward, both.forward));
  CHECK(same_confidence(read.forward, both.forward));
  CHECK(identical(read.reverse.value(), *both.reverse));
  CHECK(read.reverse->confidence.empty());
  write_result(folder.path(), "a", "q", {both.reverse.value(), std::nullopt});
  const MatchResult other = read_result(folder.path(), "a");
  CHECK(identical(other.forward, *both.reverse));
  CHECK(other.forward.confidence.empty());
  CHECK_FALSE(other.reverse.has_value());
}

TEST_CASE("stored results are damaged if any of their files is changed, cut or missing") {
  const TemporaryFolder folder;
  const auto state = [&] { return state_of_result(folder.path(), "a", "q"); };
  write_result(folder.path(), "a", "q", some_result());
  int files = 0;
  for (const char* name :
       {"a.pfm", "a_status.png", "a_confidence.pfm", "a_reverse.pfm", "a_reverse_status.png"}) {
    CAPTURE(std::string(name));
    const std::string bytes = read_file(folder / name);
    std::string changed = bytes;
    changed[bytes.size() / 2] ^= 1;
    for (const std::string& now : {changed, bytes.substr(0, bytes.size() / 2), bytes + "x"}) {
      folder.write(name, now);
      CHECK(state() == StoredState::damaged);
    }
    std::filesystem::remove(folder / name);
    CHECK(state() == StoredState::damaged);
    folder.write(name, bytes);
    CHECK(state() == StoredState::complete);
    ++files;
  }
  CHECK(folder.files() == static_cast<std::size_t>(files) + 1);
  folder.write("a.json", read_file(folder / "a.json").substr(0, 60));
  CHECK(state() == StoredState::damaged);
}
