// SPDX-License-Identifier: Apache-2.0
// Clouds and sources on the command line.
#include <algorithm>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/ground/raster.hpp"
#include "xgm/geo/image/point_cloud.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::pipeline;
using xgm::testing::TemporaryFolder;

namespace {

/// Two cells of 2 m: 10 m, measured, and 25 m, filled.
void write_small_cloud(const std::string& file) {
  PointCloud cloud;
  cloud.base = "a";
  cloud.match = "b";
  cloud.add({500000.5, 4000001.5, 10}, 100, 0.1F, false);
  cloud.add({500002.5, 4000001.5, 25}, 200, 0.2F, true);
  write_clouds(file, "EPSG:32631", 2, {cloud});
}

std::string line_of(const std::string& text, const std::string& begin) {
  const std::size_t at = text.find(begin);
  return at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
}

}  // namespace

TEST_CASE("a cloud becomes a surface, which is judged with and without what was filled") {
  const TemporaryFolder folder;
  write_small_cloud(folder / "cloud.ply");
  const Outcome made = pipeline(folder / "", "run dsm_tsgm8 --clouds cloud.ply -o out");
  CAPTURE(made.errors);
  REQUIRE(made.exit_code == 0);
  CHECK(contains(made.output, "2 x 1 cells of 2 m"));
  Raster truth = read_raster(folder / "out/dsm.tif");
  truth.values = (cv::Mat1f(1, 2) << 10.5, 20);
  write_raster(folder / "truth.tif", truth);
  const Outcome judged = pipeline(folder / "", "eval out --surface --truth truth.tif");
  CAPTURE(judged.errors);
  REQUIRE(judged.exit_code == 0);
  CHECK(contains(line_of(judged.output, "as it is "), "50.00 %    100.00 %"));
  CHECK(contains(line_of(judged.output, "as it is, measured"), "50.00 %     50.00 %"));
  CHECK(contains(line_of(judged.output, "as it is, measured"), "0.500"));
  const Outcome named =
      pipeline(folder / "", "eval out/dsm.tif --surface --truth truth.tif --source out/source.tif");
  CHECK(named.output == judged.output);
  const Outcome plain = pipeline(folder / "", "eval out/dsm.tif --surface --truth truth.tif");
  CHECK_FALSE(contains(plain.output, "measured"));
}

TEST_CASE("what clouds cannot be made a surface of, and how, is said before any work") {
  const TemporaryFolder folder;
  write_small_cloud(folder / "cloud.ply");
  write_file(folder / "cut.ply", read_file(folder / "cloud.ply").substr(0, 460));
  write_file(folder / "text.txt", "no cloud");
  const auto error = [&](const std::string& arguments, int code) {
    const Outcome outcome = pipeline(folder / "", arguments);
    CAPTURE(arguments);
    CHECK(outcome.exit_code == code);
    CHECK(std::ranges::count(outcome.errors, '\n') == 1);
    return outcome.errors;
  };
  CHECK(contains(error("run dsm_tsgm8 -o o", 2), "--clouds FILE.ply"));
  CHECK(contains(error("run tsgm8 --clouds cloud.ply -o o", 2), "type surface"));
  CHECK(contains(error("run dsm_tsgm8 --clouds cloud.ply --cloud c.ply -o o", 2),
                 "always in DIR/cloud.ply"));
  CHECK(contains(error("run dsm_tsgm8 --clouds text.txt -o o", 1), "text.txt: is no PLY file"));
  CHECK(contains(error("run dsm_tsgm8 --clouds cut.ply -o o", 1), "cut.ply: "));
  CHECK(contains(error("eval . --surface --truth cloud.ply", 2), "has no dsm.tif"));
  CHECK_FALSE(std::filesystem::exists(folder / "o"));
}
