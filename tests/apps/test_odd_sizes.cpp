// SPDX-License-Identifier: Apache-2.0
// pipeline run on images that are wide, high or tiny: maps, pictures and report within the memory
// that was allowed.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

struct Desk : TemporaryFolder {
  explicit Desk(cv::Size size, int channels = 1) {
    const ImagePair pair = shifted_pair(size, 0, 5, channels);
    write_png(*this / "left.png", picture(pair.base));
    write_png(*this / "right.png", picture(pair.match));
  }
  Outcome run(const std::string& arguments) const {
    return pipeline(path(), "run " + arguments +
                                " --left left.png --right right.png --disparities 0:3 --report "
                                "--threads 1 --log-level error -o out");
  }
  nlohmann::json record() const { return nlohmann::json::parse(read_file(*this / "out/run.json")); }
};

void check_written(const Desk& desk, cv::Size size, const Outcome& outcome) {
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 0);
  CHECK_FALSE(contains(outcome.errors, "OpenCV("));
  CHECK(read_pfm(desk / "out/disparity.pfm").size() == size);
  for (const char* name : {"out/disparity.png", "out/status.png"}) {
    CHECK(read_mask(desk / name, MaskUse::usable).value.cols <= Sampling::kMaxSide);
  }
  CHECK(std::filesystem::exists(desk / "out/report.html"));
}

}  // namespace

TEST_CASE("run: strips are matched and shown, with pictures and report in the memory allowed") {
#ifdef XGM_SANITIZED  // the program is larger
  const std::string limit = "300MB";
#else
  const std::string limit = "150MB";
#endif
  for (const cv::Size size : {cv::Size(30000, 4), cv::Size(4, 30000), cv::Size(66000, 3)}) {
    CAPTURE(size.width);
    const Desk desk(size);
    check_written(desk, size, desk.run("sgm8 --memory-limit " + limit));
#ifndef XGM_SANITIZED  // sanitizers need memory of their own
    CHECK(desk.record()["peak_memory_bytes"] < 1.1 * 150e6);
#endif
  }
}

TEST_CASE("run: what a report keeps of a pyramid's levels counts for the limit") {
  const cv::Size size(900, 700);
  const Desk desk(size, 3);
  const Outcome refused = desk.run("tsgm8 --memory-limit 40MB");
  CHECK(refused.exit_code == 2);
  CHECK(contains(refused.errors, "--memory-limit allows 40 MB"));
  check_written(desk, size, desk.run("tsgm8"));
#ifndef XGM_SANITIZED
  // Where the plan says that it fits, it does.
  const double peak = desk.record()["peak_memory_bytes"];
  for (double limit = 0.7 * peak; limit < 1.4 * peak; limit += 0.1 * peak) {
    const Outcome outcome =
        desk.run("tsgm8 --memory-limit " + std::to_string(static_cast<int>(limit / 1e6)) + "MB");
    CAPTURE(limit);
    CHECK((outcome.exit_code == 2 || desk.record()["peak_memory_bytes"] < 1.1 * limit));
  }
#endif
}

TEST_CASE("run: images of one pixel, one row and one column, alone and in a pyramid") {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(9, 1), cv::Size(1, 9)}) {
    for (const std::string name : {"sgm8", "tmgm16", "opencv_sgbm"}) {
      CAPTURE(name);
      CAPTURE(size.width);
      const Desk desk(size, 3);
      const Outcome outcome = desk.run(name);
      INFO(outcome.errors);
      CHECK((outcome.exit_code == 0 || contains(outcome.errors, "the map is empty")));
      CHECK(read_pfm(desk / "out/disparity.pfm").size() == size);
      CHECK(std::filesystem::exists(desk / "out/report.html"));
    }
  }
}
