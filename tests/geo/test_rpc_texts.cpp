// SPDX-License-Identifier: Apache-2.0
// Texts that are all but the camera of a vendor.
#include <doctest/doctest.h>

#include <limits>

#include "support/sample_camera.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/camera/read_rpc.hpp"
#include "xgm/geo/camera/write_rpc.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::sample_camera;
using xgm::testing::TemporaryFolder;

namespace {

/// The text with another value of a key.
std::string with(const std::string& key, const std::string& value) {
  std::string text = rpc_text(sample_camera());
  const std::size_t begin = text.find(key + ": ") + key.size() + 2;
  return text.replace(begin, text.find('\n', begin) - begin, value);
}

}  // namespace

TEST_CASE("a camera that is written and read is the same, digit by digit") {
  const TemporaryFolder folder;
  RpcModel extreme = sample_camera();
  extreme.row_ratio.numerator[3] = std::numeric_limits<double>::denorm_min();
  extreme.row_ratio.numerator[4] = -std::numeric_limits<double>::max();
  extreme.height.offset = 1.0 / 3;
  const auto read = read_rpc(folder.write("a_RPC.TXT", rpc_text(extreme)));
  REQUIRE(read.size() == 1);
  CHECK(rpc_text(read.front()) == rpc_text(extreme));
  CHECK(read.front().row_ratio.numerator == extreme.row_ratio.numerator);
  CHECK(read.front().height.offset == extreme.height.offset);
}

TEST_CASE("values that are no number, or two, or too large for one, are named") {
  const TemporaryFolder folder;
  for (const char* value : {"1e999", "-1e-999", "", "pixels", "+", "-.", "1 2", "5e", "nan"}) {
    CAPTURE(value);
    const std::string file = folder.write("a_RPC.TXT", with("LINE_OFF", value));
    if (std::string(value) == "5e") {
      CHECK(read_rpc(file).front().row.offset == 5);
      continue;
    }
    const std::string message = error_of([&] { read_rpc(file); });
    CHECK(contains(message, file));
    CHECK(contains(message, "line_off of the RPC model must be 1 number"));
  }
  // A sign at the end of a text, behind which there is nothing.
  CHECK(read_rpc(folder.write("a_RPC.TXT", with("LINE_OFF", "7+"))).front().row.offset == 7);
  CHECK(read_rpc(folder.write("a_RPC.TXT", with("LINE_OFF", "+7 pixels"))).front().row.offset == 7);
  CHECK(contains(error_of([&] { read_rpc(folder.write("a_RPC.TXT", with("SAMP_SCALE", "0"))); }),
                 "samp_scale of the RPC model is 0"));
}

TEST_CASE("dictionaries without an end, and lists without a bracket, end in an error at once") {
  const TemporaryFolder folder;
  CHECK(contains(error_of([&] { read_rpc(folder.write("a.yaml", "rpc: &a\n  row: *a\n")); }),
                 "lie too deep"));
  std::string laughs = "a0: &a0 {x: 1, y: 2}\n";
  for (int i = 1; i < 20; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    laughs += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " {p: " + last +
              ", q: " + last + ", r: " + last + "}\n";
  }
  CHECK(contains(error_of([&] { read_rpc(folder.write("a.json", laughs)); }), "too large"));
  std::string open = "lineNumCoef = (\n";
  for (int i = 0; i < 300000; ++i) open += "1.0,\n";
  CHECK(contains(error_of([&] { read_rpc(folder.write("a.RPB", open)); }), "a.RPB"));
}

TEST_CASE("EnMAP's XML with no model of a band is refused") {
  const TemporaryFolder folder;
  CHECK(contains(
      error_of([&] { read_rpc(folder.write("a.XML", "<level_X><RPC><b/></RPC></level_X>")); }),
      "a.XML: its RPC block holds no model"));
}
