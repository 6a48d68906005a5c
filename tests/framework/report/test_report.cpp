// SPDX-License-Identifier: Apache-2.0
// The page as a file: its numbers, its size, its texts. How browsers show it is in tests/report.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <regex>

#include "framework/report/page.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/base/error.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

Report report_of(ReportScene scene) { return {"title", "", {std::move(scene)}}; }

/// All that is between the two texts, the first time.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t begin = text.find(before);
  REQUIRE(begin != std::string::npos);
  const std::size_t first = begin + before.size();
  return text.substr(first, text.find(after, first) - first);
}

void check_numbers(double low, double high, double largest_step) {
  const ReportScene scene = random_scene({37, 23}, low, high, 3);
  const cv::Mat1f& wanted = scene.runs[0].map.disparity;
  const auto run = page_data(report_html(report_of(scene)))["scenes"][0]["runs"][0];
  const double step = run["disparity"]["step"];
  CHECK(step <= largest_step);
  const cv::Mat1d found = unpacked(run["disparity"]);
  REQUIRE(found.size() == wanted.size());
  for (int y = 0; y < wanted.rows; ++y) {
    for (int x = 0; x < wanted.cols; ++x) {
      REQUIRE(std::isnan(found(y, x)) == std::isnan(wanted(y, x)));
      if (std::isnan(found(y, x))) continue;
      REQUIRE(std::abs(found(y, x) - static_cast<double>(wanted(y, x))) <= step / 2);
    }
  }
}

}  // namespace

TEST_CASE("report: the numbers of a map are in the page, fine enough for any range") {
  check_numbers(0, 60, 1.0 / 1024);
  check_numbers(-300, 300, 1.0 / 64);
  check_numbers(-12, -11.5, 1.0 / 1024);
  check_numbers(-1e6, 1e6, 64);
}

TEST_CASE("report: whole, half and quarter pixels stay exactly what they are") {
  ReportScene scene = random_scene({16, 4}, 0, 1, 1);
  DisparityMap& map = scene.runs[0].map;
  for (int x = 0; x < 16; ++x) map.set(2, x, static_cast<float>(x * 17) - 100.25F);
  const auto run = page_data(report_html(report_of(scene)))["scenes"][0]["runs"][0];
  for (int x = 0; x < 16; ++x) CHECK(unpacked(run["disparity"])(2, x) == x * 17 - 100.25);
}

TEST_CASE("report: a confidence is a layer and a picture, if there is one") {
  ReportScene scene = random_scene({16, 4}, 0, 1, 1);
  const std::string without = report_html(report_of(scene));
  CHECK(without.find(">Confidence<") == std::string::npos);
  CHECK_FALSE(page_data(without)["scenes"][0]["runs"][0].contains("confidence"));
  cv::Mat1f& sure = scene.runs[0].map.confidence;
  sure = cv::Mat1f(4, 16, 0.25F);
  sure(1, 2) = std::numeric_limits<float>::quiet_NaN();
  const std::string with = report_html(report_of(scene));
  CHECK(with.find(">Confidence<") != std::string::npos);
  const auto packed = page_data(with)["scenes"][0]["runs"][0]["confidence"];
  CHECK(unpacked(packed)(3, 15) == 0.25);
  CHECK(std::isnan(unpacked(packed)(1, 2)));
  sure = cv::Mat1f(3, 16, 0.25F);
  CHECK_THROWS_AS(report_html(report_of(scene)), Error);
}

TEST_CASE("report: odd maps make a page: one pixel, nothing valid, no run, no truth") {
  SUBCASE("one pixel") {
    const auto data = page_data(report_html(report_of(random_scene({1, 1}, 5, 6, 2))));
    CHECK(data["scenes"][0]["grid"]["width"] == 1);
  }
  SUBCASE("nothing valid, truth nowhere known") {
    ReportScene scene = random_scene({9, 5}, 0, 9, 2);
    scene.runs[0].map = DisparityMap({9, 5});
    scene.truth.disparity.setTo(std::numeric_limits<float>::infinity());
    const auto data = page_data(report_html(report_of(scene)));
    const cv::Mat1d numbers = unpacked(data["scenes"][0]["runs"][0]["disparity"]);
    CHECK(std::all_of(numbers.begin(), numbers.end(), [](double d) { return std::isnan(d); }));
  }
  SUBCASE("no run") {
    ReportScene scene = random_scene({9, 5}, 0, 9, 2);
    scene.runs.clear();
    CHECK(page_data(report_html(report_of(scene)))["scenes"][0]["runs"].empty());
  }
  SUBCASE("no truth") {
    ReportScene scene = random_scene({9, 5}, 0, 9, 2);
    scene.truth = {};
    const std::string html = report_html(report_of(scene));
    CHECK_FALSE(page_data(html)["scenes"][0].contains("truth"));
    CHECK_FALSE(contains(html, "alt=\"Error\""));
  }
  SUBCASE("no scene") {
    CHECK(page_data(report_html({"t", "<p>tables</p>", {}}))["scenes"].empty());
  }
}

TEST_CASE("report: 6 megapixels of noise stay below 15 MB, and the page says what it left out") {
  ReportScene scene = random_scene({3000, 2000}, 0, 300, 4);
  for (int scale = 1; scale <= 8; scale *= 2) {
    const cv::Size size(3000 / scale, 2000 / scale);
    const ReportRun coarse = random_scene(size, 0, 300.0 / scale, 5).runs[0];
    const cv::Mat1i begin(size, 3), end(size, 40);
    scene.runs[0].levels.push_back(
        {{"s", double(scale), "matcher.s"}, "matcher", coarse.map, DisparityRange(begin, end)});
  }
  const std::string html = report_html(report_of(scene));
  CHECK(html.size() < 15'000'000);
  CHECK(html.size() > 5'000'000);
  const auto data = page_data(html)["scenes"][0];
  const int stride = data["grid"]["stride"];
  CHECK(stride >= 2);
  CHECK(stride <= 5);
  CHECK(contains(html, "one of " + std::to_string(stride) + " × " + std::to_string(stride)));
  const cv::Mat1d numbers = unpacked(data["runs"][0]["disparity"]);
  CHECK(numbers.cols == (3000 + stride - 1) / stride);
  const DisparityMap& map = scene.runs[0].map;
  for (int x = 0; x + 1 < numbers.cols; ++x) {  // values of real pixels, not means
    const int full = x * stride + stride / 2;
    REQUIRE(map.has_disparity(10 * stride + stride / 2, full) == !std::isnan(numbers(10, x)));
  }
}

TEST_CASE("report: names are text, whatever they hold") {
  const std::string name = "a<b>&\"'</script><!--<script>alert(1)\xff";
  ReportScene scene = random_scene({8, 6}, 0, 4, 6);
  scene.name = name;
  scene.runs[0].name = name;
  scene.runs[0].record_json =
      R"({"warnings": ["</script><img src=x onerror=alert(1)>"], "command_line": ["</pre>"]})";
  scene.runs[0].explanations_json = R"([{"x": 1, "y": 2, "verdict": "</script><b>"}])";
  Report report = report_of(scene);
  report.title = name;
  const std::string html = report_html(report);
  CHECK_FALSE(contains(html, "<b>&"));
  CHECK_FALSE(contains(html, "<!--"));
  CHECK_FALSE(contains(html, "<img src=x"));
  CHECK_FALSE(contains(html, "'</pre>'"));
  CHECK(contains(html, "<title>a&lt;b&gt;&amp;&quot;&#39;&lt;/script&gt;"));
  const auto run = page_data(html)["scenes"][0]["runs"][0];
  CHECK(run["explanations"][0]["verdict"] == "</script><b>");
  CHECK(contains(run["name"], "a<b>&\"'</script><!--<script>"));
  const std::regex closing("</script>");
  const auto closed = std::sregex_iterator(html.begin(), html.end(), closing);
  CHECK(std::distance(closed, std::sregex_iterator()) == 2);  // data and program
}

TEST_CASE("report: the page asks for nothing outside of itself") {
  const std::string html = report_html(report_of(random_scene({20, 10}, 0, 8, 7)));
  const std::regex source(R"re(\s(?:src|href)="([^"]*)")re");
  int sources = 0;
  for (auto i = std::sregex_iterator(html.begin(), html.end(), source); i != std::sregex_iterator();
       ++i, ++sources) {
    CHECK((*i)[1].str().starts_with("data:image/"));
  }
  CHECK(sources >= 6);  // left, truth, disparity, status, error, bad
  CHECK_FALSE(contains(html, "@import"));
  CHECK_FALSE(contains(html, "url("));
  CHECK(contains(html, "default-src 'none'"));
}

TEST_CASE("report: every class of every map stands in a legend") {
  const std::string html = report_html(report_of(random_scene({20, 10}, 0, 8, 7)));
  for (int i = 0; i < kStatusCount; ++i) {
    CHECK(contains(html, "</span>" + std::string(to_string(static_cast<Status>(i))) + " <b>"));
  }
  for (const char* verdict : {"good", "bad", "no disparity", "not judged"}) {
    CHECK(contains(html, std::string("</span>") + verdict));
  }
}

TEST_CASE("report: a record whose parts are of other types is shown without them") {
  for (const char* record :
       {R"({"truth": "exact"})", R"({"truth": {"region": "all"}})", R"({"stages": 1})",
        R"({"scene": []})", R"({"pipeline": {"resolved": {"a": [1, [{}]]}}})", "3", "[[]]"}) {
    ReportScene scene = random_scene({8, 6}, 0, 4, 6);
    scene.runs[0].record_json = record;
    CHECK_MESSAGE(contains(report_html(report_of(scene)), "</html>"), record);
  }
}

TEST_CASE("report: mistakes of programs are errors") {
  const auto check = [](auto spoil, const std::string& message) {
    ReportScene scene = random_scene({8, 6}, 0, 4, 6);
    spoil(scene);
    try {
      report_html(report_of(scene));
      FAIL_CHECK("no error");
    } catch (const Error& error) {
      CHECK(contains(error.message(), message));
    }
  };
  check([](ReportScene& s) { s.runs[0].map = DisparityMap({7, 6}); }, "7 x 6");
  check([](ReportScene& s) { s.truth.disparity = cv::Mat1f(6, 9, 1.F); }, "the truth is 9 x 6");
  check([](ReportScene& s) { s.left = {}; }, "no left image");
  check([](ReportScene& s) { s.runs[0].record_json = "{"; }, "the record of run is no JSON");
  check([](ReportScene& s) { s.runs[0].explanations_json = "3"; }, "not a list");
}

TEST_CASE("report: shares of bad pixels are those of the pixels that can be judged") {
  ReportScene scene = random_scene({10, 1}, 0, 4, 6);
  scene.truth.disparity.setTo(10);
  for (int x = 0; x < 10; ++x) scene.runs[0].map.set(0, x, x < 4 ? 10.5F : 12.F);
  scene.truth.non_occluded(0, 8) = 128;  // not judged, like the unknown one beside it
  scene.truth.disparity(0, 9) = std::numeric_limits<float>::infinity();
  const std::string html = report_html(report_of(scene));
  const std::string legend = between(html, "<b>Off by more than 1 px, non-occluded</b>", "</ul>");
  CHECK(contains(legend, "good <b>50.00 %</b>"));
  CHECK(contains(legend, "bad <b>50.00 %</b>"));
  CHECK(contains(legend, "no disparity <b>0.00 %</b>"));
}
