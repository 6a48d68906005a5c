// SPDX-License-Identifier: Apache-2.0
#include "jobs/coarse_files.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <vector>

#include "xgm/base/error.hpp"
#include "xgm/data/crop.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/output_folder.hpp"

namespace xgm::tiles {
namespace {

std::string strip_name(const TileJob& job, int index) {
  return job.name + "_" + std::to_string(index + 1);
}

/// How the rows of the maps are cut.
struct Strips {
  int rows = 0;  ///< of each but the last
  int all = 0;   ///< of the maps

  int count() const { return (all + rows - 1) / rows; }
  cv::Range of(int index) const { return {index * rows, std::min(all, (index + 1) * rows)}; }
  /// The strips that hold some of the rows.
  cv::Range holding(cv::Range wanted) const {
    const cv::Range some(std::clamp(wanted.start, 0, all), std::clamp(wanted.end, 0, all));
    return {some.start / rows, (some.end + rows - 1) / rows};
  }
};

/// Throws Error if the record is none of strips.
Strips strips_of(const JobManifest& manifest, const TileJob& job) {
  const std::string file = result_file(manifest, job);
  const Json record = Json::parse(read_file(file));
  const Strips strips{static_cast<int>(record.at("strip_rows").number()),
                      static_cast<int>(record.at("rows").number())};
  if (strips.rows < 1 || strips.all < 1) throw Error(file + ": is no record of coarse maps");
  return strips;
}

template <class Pixel>
void stack(const std::vector<MatchResult>& strips,
           const std::function<cv::Mat_<Pixel>(const MatchResult&)>& of, cv::Mat_<Pixel>& all) {
  std::vector<cv::Mat_<Pixel>> parts;
  for (const MatchResult& strip : strips) parts.push_back(of(strip));
  if (!parts.front().empty()) cv::vconcat(parts, all);
}

/// One map below the other. `view` chooses that of a result.
DisparityMap stacked(const std::vector<MatchResult>& strips,
                     const std::function<const DisparityMap&(const MatchResult&)>& view) {
  DisparityMap all;
  stack<float>(
      strips, [&](const auto& strip) { return view(strip).disparity; }, all.disparity);
  stack<std::uint8_t>(
      strips, [&](const auto& strip) { return view(strip).status; }, all.status);
  stack<float>(
      strips, [&](const auto& strip) { return view(strip).confidence; }, all.confidence);
  return all;
}

}  // namespace

void write_coarse(const JobManifest& manifest, const TileJob& job, const MatchResult& maps,
                  int strip, double seconds) {
  const std::string folder = jobs_folder(manifest), question = question_hash(manifest);
  make_output_folder(folder);
  remove_file(result_file(manifest, job));  // what it says is not true from now on
  const cv::Size size = maps.forward.size();
  const Strips strips{strip, size.height};
  std::vector<std::string> records;
  for (int i = 0; i < strips.count(); ++i) {
    const cv::Range rows = strips.of(i);
    const std::string name = strip_name(job, i);
    write_result(folder, name, question,
                 crop(maps, cv::Rect(0, rows.start, size.width, rows.size())));
    records.push_back(name + ".json");
  }
  Json more = {{"strip_rows", strips.rows}, {"rows", strips.all}};
  more.update(facts_of(job, seconds));
  write_record(folder, job.name, question, records, more);
}

CoarseState state_of_coarse(const JobManifest& manifest, const TileJob& job, cv::Range rows) {
  const std::string folder = jobs_folder(manifest), question = question_hash(manifest);
  CoarseState found{state_of_result(folder, job.name, question), result_file(manifest, job)};
  if (found.state != StoredState::complete) return found;
  try {
    const cv::Range needed = strips_of(manifest, job).holding(rows);
    for (int i = needed.start; i < needed.end; ++i) {
      if (state_of_result(folder, strip_name(job, i), question) == StoredState::complete) continue;
      const std::filesystem::path record = strip_name(job, i) + ".json";
      return {StoredState::damaged, (std::filesystem::path(folder) / record).string()};
    }
  } catch (const Error&) {
    found.state = StoredState::damaged;
  }
  return found;
}

CoarseMaps read_coarse(const JobManifest& manifest, const TileJob& job, cv::Range rows, int scale) {
  const Strips strips = strips_of(manifest, job);
  const cv::Range needed = strips.holding(rows);
  std::vector<MatchResult> found;
  for (int i = needed.start; i < needed.end; ++i) {
    found.push_back(read_result(jobs_folder(manifest), strip_name(job, i)));
  }
  if (found.empty()) throw Error(result_file(manifest, job) + ": holds no rows of the tile");
  CoarseMaps coarse{.scale = scale, .maps = {}, .first_row = strips.of(needed.start).start};
  coarse.maps.forward =
      stacked(found, [](const auto& strip) -> const DisparityMap& { return strip.forward; });
  if (found.front().reverse) {
    coarse.maps.reverse =
        stacked(found, [](const auto& strip) -> const DisparityMap& { return *strip.reverse; });
  }
  return coarse;
}

}  // namespace xgm::tiles
