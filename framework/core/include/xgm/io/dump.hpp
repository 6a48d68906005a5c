// SPDX-License-Identifier: Apache-2.0
// Writes the results of chosen stages while a pipeline runs, for inspection.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/stage/context.hpp"

namespace xgm {

/// A file that a dump wrote. Volumes are dense over [first_disparity, ...); the file itself does
/// not contain the first disparity.
struct DumpedFile {
  std::string file;
  std::string stage_path;
  int first_disparity = 0;  ///< volumes only
};

/// Writes results of the stages whose path matches a shell pattern ("*", "matcher.*.cost",
/// "*filters[[]0]*"; "*" also crosses dots) or equals it:
/// - image pairs: <path>.left.png, <path>.right.png
/// - ranges: <path>.min.pfm, <path>.max.pfm (both included; +inf = empty)
/// - maps: <path>.disparity.pfm, <path>.status.png; results of matchers one set per view
/// - volumes: <path>.npy, shape (height, width, disparities) over the hull of all ranges, unsigned
///   8 or 16 bit, the largest value = no match
/// A stage that runs again under the same path gets ".2", ".3" and so on.
class XGM_API Dumper final : public Observer {
 public:
  /// `announce` is told the name of each file before it is written.
  Dumper(
      std::string folder, std::string pattern,
      std::function<void(const std::string&)> announce = [](const std::string&) {});

  bool wants(const std::string& stage_path) const;
  void stage_end(const StagePlace& place, const StageStatistics& statistics,
                 const Artifact& result) override;
  /// Throws Error if a file cannot be written.
  void write(const std::string& stage_path, const Artifact& result);
  const std::vector<DumpedFile>& files() const { return files_; }

 private:
  std::string folder_, pattern_;
  std::function<void(const std::string&)> announce_;
  std::map<std::string, int> runs_;
  std::vector<DumpedFile> files_;
};

}  // namespace xgm
