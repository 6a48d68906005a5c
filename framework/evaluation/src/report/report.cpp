// SPDX-License-Identifier: Apache-2.0
#include "xgm/evaluation/report.hpp"

#include <algorithm>

#include "report/assets.hpp"
#include "report/document.hpp"
#include "report/scene_html.hpp"
#include "report/viewer_data.hpp"

namespace xgm {
namespace {

using namespace report;

constexpr double kMaxPixels = 1'500'000;
constexpr double kFewestPixels = 2'000;
constexpr double kBytesPerPixel = 6;  // and run, about, in the page
constexpr int kAttempts = 8;

std::string contents(const Report& page) {
  if (page.scenes.size() < 2) return "";
  std::string html = "<nav aria-label=\"Scenes\"><ul>";
  for (std::size_t i = 0; i < page.scenes.size(); ++i) {
    html += "<li><a href=\"#scene-" + std::to_string(i) + "\">" + html_text(page.scenes[i].name) +
            "</a></li>";
  }
  return html + "</ul></nav>\n";
}

std::string page_of(const Report& page, const std::vector<SceneView>& views, double pixels) {
  std::string html = page.tables_html + kViewer + contents(page);
  for (std::size_t i = 0; i < views.size(); ++i)
    html += scene_html(views[i], i, views.size() == 1, pixels);
  return document(page.title, html,
                  "<script type=\"application/json\" id=\"data\">" +
                      script_text(viewer_data(views, pixels)) + "</script>\n<script>" + kProgram +
                      "</script>");
}

}  // namespace

std::string report_html(const Report& report) {
  std::vector<SceneView> views;
  std::size_t runs = 0;
  for (const ReportScene& scene : report.scenes) {
    views.push_back(view_of(scene));
    runs += scene.runs.size();
  }
  const double affordable = static_cast<double>(report.max_bytes) / kBytesPerPixel;
  double pixels =
      std::min(kMaxPixels, affordable / static_cast<double>(std::max<std::size_t>(1, runs)));
  std::string html;
  for (int i = 0; i < kAttempts; ++i) {
    html = page_of(report, views, std::max(pixels, kFewestPixels));
    if (html.size() <= report.max_bytes || pixels <= kFewestPixels) break;
    // How well maps compress is known now.
    pixels *= 0.9 * static_cast<double>(report.max_bytes) / static_cast<double>(html.size());
  }
  return html;
}

double bytes_to_report(cv::Size size) {
  constexpr double kCopies = 5;           // of the maps' text: encoded, JSON, script and page
  constexpr double kWithLevels = 2;       // what a pyramid adds to the maps
  constexpr double kNumbersPerPixel = 9;  // verdicts, and those whose quantiles colours span
  const double pixels = static_cast<double>(size.width) * size.height;
  const double page = kWithLevels * kBytesPerPixel * std::min(kMaxPixels, pixels);
  return kCopies * std::min(page, static_cast<double>(Report{}.max_bytes)) +
         kNumbersPerPixel * pixels;
}

}  // namespace xgm
