// SPDX-License-Identifier: Apache-2.0
#include "xgm/evaluation/report_page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "report/document.hpp"
#include "report/html.hpp"
#include "report/pictures.hpp"
#include "report/record_html.hpp"
#include "report/stages_html.hpp"
#include "xgm/evaluation/report.hpp"
#include "xgm/io/sampling.hpp"

namespace xgm {
namespace {

using namespace report;

constexpr double kMaxPixels = 400'000;

/// Colours that are told apart by colour-blind readers (Okabe and Ito, 2008), blue-green-red; the
/// first one is that of what needs no attention.
constexpr std::array<std::array<uchar, 3>, 11> kColours{{{238, 238, 238},
                                                         {0, 94, 213},
                                                         {178, 114, 0},
                                                         {66, 228, 240},
                                                         {115, 158, 0},
                                                         {167, 121, 204},
                                                         {233, 180, 86},
                                                         {0, 159, 230},
                                                         {42, 42, 130},
                                                         {190, 220, 160},
                                                         {60, 60, 60}}};

std::vector<Class> classes_of(const std::vector<std::string>& names) {
  std::vector<Class> classes;
  for (const std::string& name : names) {
    const auto& c = kColours[std::min(classes.size(), kColours.size() - 1)];
    classes.push_back({name, {c[0], c[1], c[2]}});
  }
  return classes;
}

template <class Pixel>
cv::Mat_<Pixel> preview(const cv::Mat_<Pixel>& whole) {
  return sampled(whole, Sampling::within(whole.size(), kMaxPixels));
}

}  // namespace

void Page::end_gallery() {
  if (gallery_.empty()) return;
  body_ += "<div class=\"gallery\">" + gallery_ + "</div>\n";
  gallery_.clear();
}

void Page::show(const std::string& figure) { gallery_ += figure; }

void Page::heading(const std::string& text) {
  end_gallery();
  body_ += "<h4>" + html_text(text) + "</h4>\n";
}

void Page::note(const std::string& text) {
  end_gallery();
  body_ += "<p class=\"note\">" + html_text(text) + "</p>\n";
}

void Page::html(const std::string& html) {
  end_gallery();
  body_ += html;
}

void Page::facts(const std::vector<std::pair<std::string, std::string>>& facts) {
  end_gallery();
  body_ += facts_list(facts);
}

void Page::table(const std::vector<std::string>& head,
                 const std::vector<std::vector<std::string>>& rows) {
  end_gallery();
  const auto escaped = [](std::vector<std::string> cells) {
    for (std::string& cell : cells) cell = html_text(cell);
    return cells;
  };
  std::vector<Row> lines;
  for (const auto& row : rows) lines.push_back(escaped(row));
  body_ += report::table(escaped(head), lines);
}

void Page::picture(const std::string& title, const cv::Mat3b& picture) {
  const double shrink = std::sqrt(kMaxPixels / static_cast<double>(picture.total()));
  cv::Mat3b small = picture;
  if (shrink < 1) cv::resize(picture, small, {}, shrink, shrink, cv::INTER_AREA);
  show(figure({title, png_uri(small), ""}));
}

void Page::numbers(const std::string& title, const cv::Mat1f& values, const std::string& unit,
                   const std::string& missing) {
  const Span span = colour_span({values});
  show(figure({title, png_uri(in_ramp(preview(values), disparity_ramp(), span)),
               ramp_legend(disparity_ramp(), span, " " + unit, missing)}));
}

void Page::classes(const std::string& title, const cv::Mat1b& codes,
                   const std::vector<std::string>& names) {
  const std::vector<Class> classes = classes_of(names);
  show(figure({title, png_uri(in_classes(preview(codes), classes)),
               class_legend(classes, shares_of(codes, classes.size()))}));
}

void Page::warnings(const std::string& record_json) {
  end_gallery();
  body_ += warnings_html(Json::parse(record_json));
}

void Page::record(const std::string& record_json) {
  end_gallery();
  const Json record = Json::parse(record_json);
  body_ += stages_html(record) + "<h4>Configuration</h4>" + configuration_html(record);
}

std::string Page::text() const {
  Page whole = *this;
  whole.end_gallery();
  return document(title_, whole.body_);
}

}  // namespace xgm
