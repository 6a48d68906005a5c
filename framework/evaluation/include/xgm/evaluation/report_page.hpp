// SPDX-License-Identifier: Apache-2.0
// Pages of other rooms' results, made of the report's pieces: self-contained HTML files that need
// no network and no JavaScript.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <utility>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

/// What is given as text is escaped; what is given as HTML stands in the page as it is.
class XGM_API Page {
 public:
  explicit Page(std::string title) : title_(std::move(title)) {}

  void heading(const std::string& text);
  void note(const std::string& text);
  void html(const std::string& html);
  /// Names and values of the most important figures.
  void facts(const std::vector<std::pair<std::string, std::string>>& facts);
  /// Texts; the first column names the row.
  void table(const std::vector<std::string>& head,
             const std::vector<std::vector<std::string>>& rows);
  /// Figures stand in a gallery, from one heading to the next other thing.
  void picture(const std::string& title, const cv::Mat3b& picture);
  /// In colours that 98 % of the finite numbers span, with a legend. `missing`: what NaN means.
  void numbers(const std::string& title, const cv::Mat1f& values, const std::string& unit,
               const std::string& missing);
  /// Codes, each the index of a name, with their shares.
  void classes(const std::string& title, const cv::Mat1b& codes,
               const std::vector<std::string>& names);
  /// What run.json says of all runs: its warnings; then where the time went, and the configuration.
  /// Throws Error if it is no JSON.
  void warnings(const std::string& record_json);
  void record(const std::string& record_json);

  std::string text() const;

 private:
  void show(const std::string& figure);
  void end_gallery();

  std::string title_, body_, gallery_;
};

}  // namespace xgm
