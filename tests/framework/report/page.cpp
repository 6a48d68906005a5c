// SPDX-License-Identifier: Apache-2.0
#include "framework/report/page.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <random>

namespace xgm::testing {
namespace {

std::vector<uchar> from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<uchar> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t digit = digits.find(c);
    REQUIRE(digit != std::string::npos);
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<uchar>(bits >> count & 255));
  }
  return bytes;
}

}  // namespace

nlohmann::json page_data(const std::string& html) {
  const std::string opening = R"(<script type="application/json" id="data">)";
  const std::size_t begin = html.find(opening);
  REQUIRE(begin != std::string::npos);
  const std::size_t end = html.find("</script>", begin);
  REQUIRE(end != std::string::npos);
  const std::size_t first = begin + opening.size();
  return nlohmann::json::parse(html.substr(first, end - first));
}

cv::Mat1d unpacked(const nlohmann::json& packed) {
  const cv::Mat codes = cv::imdecode(from_base64(packed["png"]), cv::IMREAD_UNCHANGED);
  REQUIRE(codes.type() == CV_16UC1);
  cv::Mat1d numbers(codes.size());
  for (int y = 0; y < codes.rows; ++y) {
    for (int x = 0; x < codes.cols; ++x) {
      const auto code = codes.at<std::uint16_t>(y, x);
      numbers(y, x) = code == 0
                          ? std::numeric_limits<double>::quiet_NaN()
                          : (packed["first"].get<double>() + code) * packed["step"].get<double>();
    }
  }
  return numbers;
}

ReportScene random_scene(cv::Size size, double low, double high, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> disparity(static_cast<float>(low),
                                                  static_cast<float>(high));
  ReportScene scene{"scene", Image(cv::Mat1f(size)), {cv::Mat1f(size), {}, {}, {}}, {}};
  scene.truth.non_occluded = cv::Mat1b(size, 255);
  ReportRun run{"run", "", DisparityMap(size)};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      scene.left.planes[0](y, x) = static_cast<float>(random() % 256);
      scene.truth.disparity(y, x) = disparity(random);
      if (random() % 8 == 0) {
        run.map.invalidate(y, x, static_cast<Status>(2 + random() % 6));
      } else {
        run.map.set(y, x, disparity(random));
      }
    }
  }
  scene.runs.push_back(std::move(run));
  return scene;
}

}  // namespace xgm::testing
