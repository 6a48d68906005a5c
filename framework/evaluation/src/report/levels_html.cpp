// SPDX-License-Identifier: Apache-2.0
#include "report/levels_html.hpp"

#include <cmath>

#include "report/html.hpp"
#include "report/pictures.hpp"
#include "report/record_html.hpp"
#include "report/stages_html.hpp"
#include "xgm/base/text.hpp"

namespace xgm::report {
namespace {

std::string scale_text(double scale) {
  return scale == 1 ? "full size" : "1/" + short_number(scale);
}

/// A cost of one level: what it searched, what it found and what it took.
Row row_of(const ReportLevel& level, const Json& record) {
  Row row{scale_text(level.level.scale),
          std::to_string(level.map.size().width) + " × " + std::to_string(level.map.size().height)};
  if (level.range) {
    const Interval hull = level.range->hull();
    row.push_back(std::to_string(hull.begin) + " to " + std::to_string(hull.end - 1));
    row.push_back(number(mean_count(*level.range), 1));
  } else {
    row.insert(row.end(), 2, "–");
  }
  row.push_back(percent(level.map.density()));
  row.push_back(seconds(seconds_of(record, level.matcher_path)));
  return row;
}

std::string disparity_figure(const ReportLevel& level, const Span& span, const Sampling& sampling) {
  const Span here{span.low / level.level.scale, span.high / level.level.scale};
  const cv::Mat1f values = sampled(level.map.disparity, sampling);
  return figure({"Disparity, " + scale_text(level.level.scale),
                 png_uri(in_ramp(values, disparity_ramp(), here)),
                 ramp_legend(disparity_ramp(), here, " px", "none")});
}

std::string range_figure(const ReportLevel& level, const Sampling& sampling) {
  cv::Mat1f counts = range_maps(*level.range, sampling).count;
  double maximum = 1;
  cv::minMaxLoc(counts, nullptr, &maximum);
  counts.setTo(std::nanf(""), counts == 0);
  const Span span{0, std::max(1.0, maximum)};
  return figure({"Disparities searched, " + scale_text(level.level.scale),
                 png_uri(in_ramp(counts, error_ramp(), span)),
                 ramp_legend(error_ramp(), span, "", "nothing to search")});
}

}  // namespace

std::string levels_html(const SceneView& view, std::size_t i, double pixels) {
  const ReportRun& run = view.scene.runs[i];
  if (run.levels.empty()) return "";
  std::vector<Row> rows;
  std::string figures;
  for (const ReportLevel& level : run.levels) {
    rows.push_back(row_of(level, view.records[i]));
    const Sampling sampling = Sampling::within(level.map.size(), pixels / 4);
    figures += disparity_figure(level, view.span, sampling);
    if (level.range) figures += range_figure(level, sampling);
  }
  return "<h4>Levels of the pyramid</h4>" +
         table({"Level", "Pixels", "Searched, px", "Mean number", "With a disparity", "Time"},
               rows) +
         "<p class=\"note\">Everything of a level is in its own pixels. Maps are those of the base "
         "view as they leave the level.</p><div class=\"gallery levels\">" +
         figures + "</div>\n";
}

}  // namespace xgm::report
