// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <opencv2/imgcodecs.hpp>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/image_io.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::TemporaryFolder;

namespace {

struct Read {
  std::vector<int> values;
  std::string warning;  ///< "" if there is none
};

Read read(const cv::Mat& image, MaskUse use) {
  const TemporaryFolder folder;
  cv::imwrite(folder / "mask.png", image);
  const auto [mask, warnings] = read_mask(folder / "mask.png", use);
  REQUIRE(warnings.size() <= 1);
  if (!warnings.empty()) CHECK(contains(warnings.front(), folder / "mask.png: "));
  return {{mask.begin(), mask.end()}, warnings.empty() ? "" : warnings.front()};
}

Read read(std::initializer_list<int> values, MaskUse use) {
  cv::Mat1b image(1, static_cast<int>(values.size()));
  std::transform(values.begin(), values.end(), image.begin(),
                 [](int value) { return static_cast<uchar>(value); });
  return read(image, use);
}

}  // namespace

TEST_CASE("masks: the values of their use are silent") {
  for (const MaskUse use : {MaskUse::usable, MaskUse::judged, MaskUse::objects}) {
    for (const auto& values : {std::initializer_list<int>{0, 255}, {0, 0}, {255, 255}}) {
      CHECK(read(values, use).values == std::vector<int>(values));
      CHECK(read(values, use).warning.empty());
    }
  }
  CHECK(read({0, 128, 255}, MaskUse::judged).warning.empty());
  CHECK(read({0, 1, 2, 9}, MaskUse::objects).warning.empty());
}

TEST_CASE("masks: zeros and ones are read as 0 and 255, and that is said") {
  for (const MaskUse use : {MaskUse::usable, MaskUse::judged}) {
    const Read mask = read({0, 1, 1}, use);
    CHECK(mask.values == std::vector<int>{0, 255, 255});
    CHECK(contains(mask.warning, "holds the values 0 and 1: 1 is taken for 255"));
  }
  CHECK(read({0, 1}, MaskUse::objects).values == std::vector<int>{0, 1});
}

TEST_CASE("masks: other values are listed, and what they are taken for") {
  const Read labels = read({0, 3, 1, 2, 3, 4, 5, 6, 7}, MaskUse::usable);
  CHECK(
      contains(labels.warning, "holds the values 0, 1, 2, 3, 4, 5, ..., not 0 and 255: all but 0"));
  CHECK(labels.values == std::vector<int>{0, 3, 1, 2, 3, 4, 5, 6, 7});
  CHECK(contains(read({0, 128, 255}, MaskUse::usable).warning, "0, 128, 255, not 0 and 255"));
  CHECK(contains(read({0, 254, 255}, MaskUse::judged).warning,
                 "0, 254, 255, not 0, 128 and 255: only 255 is taken"));
  CHECK(read(cv::Mat1w((cv::Mat1w(1, 2) << 0, 1)), MaskUse::usable).values ==
        std::vector<int>{0, 255});
}

TEST_CASE("masks: what alpha hides is 0, and that is said") {
  const cv::Mat4b image = (cv::Mat4b(1, 3) << cv::Vec4b(255, 255, 255, 255),
                           cv::Vec4b(255, 255, 255, 0), cv::Vec4b(0, 0, 0, 255));
  const Read mask = read(image, MaskUse::usable);
  CHECK(mask.values == std::vector<int>{255, 0, 0});
  CHECK(contains(mask.warning, "pixels without data (alpha 0, NaN or GDAL_NODATA)"));
}
