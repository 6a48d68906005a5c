// SPDX-License-Identifier: Apache-2.0
#include "report/scene_html.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "report/html.hpp"
#include "report/levels_html.hpp"
#include "report/pictures.hpp"
#include "report/record_html.hpp"
#include "report/stages_html.hpp"
#include "xgm/io/outputs.hpp"

namespace xgm::report {
namespace {

constexpr double kMaxPreviewPixels = 400'000;
constexpr double kBadDelta = 1;  // px, of the static picture

std::string left_figure(const SceneView& view, std::size_t index, double pixels) {
  const Sampling sampling = Sampling::within(view.scene.left.size(), pixels);
  return figure({"Left image", jpeg_uri(picture(view.scene.left, sampling)), "",
                 "left-" + std::to_string(index)});
}

std::string disparity_figure(const std::string& title, const cv::Mat1f& map, const SceneView& view,
                             const Sampling& sampling, const std::string& missing) {
  return figure({title, png_uri(in_ramp(sampled(map, sampling), disparity_ramp(), view.span)),
                 ramp_legend(disparity_ramp(), view.span, " px", missing)});
}

std::string status_figure(const cv::Mat1b& codes, const Sampling& sampling) {
  return figure({"Status", png_uri(in_classes(sampled(codes, sampling), status_classes())),
                 class_legend(status_classes(), shares_of(codes, status_classes().size()))});
}

std::string confidence_figure(const DisparityMap& map, const Sampling& sampling) {
  if (map.confidence.empty()) return "";
  const Span span{0, 1};
  return figure({"Confidence",
                 png_uri(in_ramp(sampled(map.confidence, sampling), disparity_ramp(), span)),
                 ramp_legend(disparity_ramp(), span, "", "none")});
}

/// The verdicts' shares among the pixels judged; none for those that were not.
std::vector<double> shares_of_judged(const cv::Mat1b& codes) {
  std::vector<double> shares = shares_of(codes, bad_classes().size());
  const double judged = 1 - shares.back();
  shares.pop_back();
  for (double& share : shares) share /= judged;
  return shares;
}

std::string bad_figure(const DisparityMap& map, const GroundTruth& truth,
                       const Sampling& sampling) {
  const cv::Mat1b codes = verdicts(map, truth, kBadDelta);
  const std::string title = "Off by more than 1 px";
  return figure({truth.non_occluded.empty() ? title : title + ", non-occluded",
                 png_uri(in_classes(sampled(codes, sampling), bad_classes())),
                 class_legend(bad_classes(), shares_of_judged(codes))});
}

std::string truth_figures(const SceneView& view, const ReportRun& run, const Sampling& sampling) {
  if (!view.has_truth()) return "";
  const GroundTruth& truth = view.scene.truth;
  const cv::Mat1f errors = error_map(run.map, truth.disparity, sampling);
  const Span span{0, kErrorSpan};
  return figure(
             {"Error", png_uri(in_ramp(errors, error_ramp(), span)),
              ramp_legend(error_ramp(), span, " px", "no disparity or no truth", Above::often)}) +
         bad_figure(run.map, truth, sampling);
}

/// `before`: figures that come first.
std::string run_html(const SceneView& view, std::size_t i, const Sampling& sampling,
                     const std::string& before) {
  const ReportRun& run = view.scene.runs[i];
  const Json& record = view.records[i];
  return "<section class=\"run\"><h3>" + html_text(run.name) + "</h3>\n" + facts_html(record) +
         warnings_html(record) + "<div class=\"gallery\">" + before +
         disparity_figure("Disparity", run.map.disparity, view, sampling, "none: see the status") +
         status_figure(run.map.status, sampling) + confidence_figure(run.map, sampling) +
         truth_figures(view, run, sampling) + "</div>\n" + evaluation_html(record) +
         levels_html(view, i, static_cast<double>(sampling.shown().area())) + stages_html(record) +
         "<h4>Configuration</h4>" + configuration_html(record) + "</section>\n";
}

/// Puts the smallest numbers in bold.
Row comparison_row(const std::string& name, const std::vector<double>& values,
                   std::string (*format)(double)) {
  double best = INFINITY;
  for (const double value : values) {
    if (value < best) best = value;
  }
  Row row{name};
  for (const double value : values) {
    row.push_back(value == best ? "<b>" + format(value) + "</b>" : format(value));
  }
  return row;
}

std::string comparison_html(const SceneView& view) {
  if (view.scene.runs.size() < 2) return "";
  Row head{"Figure"};
  for (const ReportRun& run : view.scene.runs) head.push_back(html_text(run.name));
  std::vector<Row> rows;
  const auto add = [&](const std::string& name, auto value, std::string (*format)(double)) {
    std::vector<double> values;
    for (const Json& record : view.records) values.push_back(value(record));
    const auto known = [](double v) { return std::isfinite(v); };
    if (std::any_of(values.begin(), values.end(), known)) {
      rows.push_back(comparison_row(name, values, format));
    }
  };
  add(
      "pixels without a disparity",
      [](const Json& record) { return 1 - number_at(record, "/valid_share"); }, percent);
  for (const double delta : {0.5, 1.0, 2.0, 4.0}) {
    add(
        "total error &gt; " + number(delta, 1) + " px",
        [&](const Json& record) { return total_error(record, delta); }, percent);
  }
  add("average error", average_error, [](double value) { return number(value, 3) + " px"; });
  add(
      "matching", [](const Json& record) { return number_at(record, "/seconds/matching"); },
      seconds);
  add(
      "memory at most", [](const Json& record) { return number_at(record, "/peak_memory_bytes"); },
      megabytes);
  if (rows.empty()) return "";
  return "<h3>Side by side</h3>" + table(head, rows) +
         "<p class=\"note\">Errors are those of the non-occluded pixels where they are known. The "
         "smallest number of each row is bold.</p>\n";
}

std::string sampling_note(const SceneView& view, double pixels) {
  const int stride = Sampling::within(view.scene.left.size(), pixels).stride;
  if (stride == 1) return "";
  return "<p class=\"note\">The maps are large: the viewer has one of " + std::to_string(stride) +
         " × " + std::to_string(stride) +
         " pixels of each. Values shown are those of these pixels; figures in tables and legends "
         "of the pictures are over all.</p>\n";
}

}  // namespace

std::string scene_html(const SceneView& view, std::size_t index, bool alone, double pixels) {
  const ReportScene& scene = view.scene;
  const Sampling previews =
      Sampling::within(scene.left.size(), std::min(pixels, kMaxPreviewPixels));
  std::string html = "<section class=\"scene\" id=\"scene-" + std::to_string(index) + "\"><h2>" +
                     html_text(alone ? "Results" : scene.name) + "</h2>\n" +
                     sampling_note(view, pixels) + comparison_html(view);
  std::string figures = left_figure(view, index, pixels);
  if (view.has_truth()) {
    figures += disparity_figure("True disparity", scene.truth.disparity, view, previews, "unknown");
  }
  if (scene.runs.size() != 1) {  // one run shows them among its own
    html += "<div class=\"gallery\">" + std::exchange(figures, "") + "</div>\n";
  }
  for (std::size_t i = 0; i < scene.runs.size(); ++i) html += run_html(view, i, previews, figures);
  return html + "</section>\n";
}

}  // namespace xgm::report
