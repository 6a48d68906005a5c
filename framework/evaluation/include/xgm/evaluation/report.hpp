// SPDX-License-Identifier: Apache-2.0
// Results as one page for people: a self-contained HTML file that needs no network, and shows its
// pictures and tables without JavaScript, too.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/data/ground_truth.hpp"
#include "xgm/data/image.hpp"
#include "xgm/stage/context.hpp"

namespace xgm {

/// One level of a pyramid, base view. All disparities are px of the level.
struct ReportLevel {
  Level level;                          ///< its place: path, name and scale
  std::string matcher_path;             ///< of the matcher that matched it: "matcher.s4.matcher"
  DisparityMap map;                     ///< as it left the level's matcher
  std::optional<DisparityRange> range;  ///< what was searched; none: not known
};

/// One pipeline's result on one scene.
struct ReportRun {
  std::string name;                   ///< of the pipeline, unique in its scene
  std::string record_json;            ///< content of run.json; may be empty
  DisparityMap map;                   ///< of the base view, of the scene's size
  std::vector<ReportLevel> levels{};  ///< coarsest first; empty without a pyramid
  /// What is known of single pixels, for the cost curves: explain.json, an array of {x, y, levels:
  /// [{scale, range: [first, last], costs, sums, winner, runner_up, ...}], ...}. May be empty; any
  /// part of it may be missing.
  std::string explanations_json{};
};

struct ReportScene {
  std::string name;
  Image left;
  GroundTruth truth;  ///< as far as it is known; of the left view only the disparity and the
                      ///< non-occluded mask are shown
  std::vector<ReportRun> runs;
};

struct Report {
  std::string title;
  std::string tables_html{};  ///< shown above the pictures as it is: text in it is escaped already
  std::vector<ReportScene> scenes;
  /// The page is kept below, by showing only every second, third, ... pixel of large maps. Values
  /// shown are always those of real pixels, and the page says which.
  std::size_t max_bytes = 14'500'000;
};

/// The page. Throws Error if the maps, the truth and the image of a scene are not of one size, or
/// a JSON text is none.
XGM_API std::string report_html(const Report& report);

/// Bytes that a page takes, while it is made, that shows one run on images of this size.
XGM_API double bytes_to_report(cv::Size size);

/// Text as it stands in HTML, in attributes too: & < > " ' escaped, bytes that are no UTF-8
/// replaced.
XGM_API std::string html_text(const std::string& text);

/// Keeps what a report shows of a pyramid's levels: copies of their maps and ranges.
class XGM_API LevelCollector final : public Observer {
 public:
  /// Of a level: a disparity, a status, the two ends of an interval.
  static constexpr double kBytesPerPixel = sizeof(float) + 1 + 2 * sizeof(int);

  void stage_input(const StagePlace& place, const Artifact& input) override;
  void stage_end(const StagePlace& place, const StageStatistics& statistics,
                 const Artifact& result) override;
  /// The levels that have a map, coarsest first.
  std::vector<ReportLevel> levels() const;

 private:
  /// The level that this matcher is the outermost one of, made if need be; null if it is none of a
  /// level's base view.
  ReportLevel* level_of(const StagePlace& matcher);
  std::vector<ReportLevel> levels_;
};

}  // namespace xgm
