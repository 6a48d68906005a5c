// SPDX-License-Identifier: Apache-2.0
// The output folder of a run, which holds the files of one run only.
#pragma once

#include <string>
#include <vector>

#include "xgm/evaluation/run_record.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/io/require_apart.hpp"

namespace xgm {

/// What runs write there beside the maps and dumps.
inline constexpr const char* kRecordFile = "run.json";
inline constexpr const char* kReportFile = "report.html";
inline constexpr const char* kExplanationsFile = "explain.json";
inline constexpr const char* kDumpFolder = "dump";
inline constexpr const char* kUnfinishedFolder = "unfinished.xgm";

/// Belongs to one run as long as it exists. Before the run's first file is there, what an earlier
/// run wrote is removed, its record first. From then on until the record is written,
/// unfinished.json lists what has been written, so that the next run knows what a run that did not
/// end has left. A folder that a run makes and writes nothing to does not stay.
class XGM_API RunFolder {
 public:
  /// Makes the folder. `planned`: the files that the run is going to write, here or elsewhere;
  /// `optional`: names that its results may have, too, beside those of all runs. Throws UsageError
  /// if an input would be lost, another run is at work here, or a file is here that would be taken
  /// for this run's and that no run has written.
  RunFolder(const std::string& folder, const std::vector<NamedFile>& planned,
            const std::vector<NamedFile>& inputs, const std::vector<std::string>& optional = {});

  std::string file(const std::string& name) const;

  /// Before the first file is written: removes what is of an earlier run. Throws Error.
  void begin();
  /// Before a file in the folder is written that was not planned.
  void announce(const std::string& file);
  /// The files written so far.
  std::vector<OutputFile> outputs() const;
  /// After the record: all is there.
  void end();
  /// Removes what was announced: nobody waits for it any more.
  void discard();

 private:
  void refuse_lookalikes(const std::vector<std::string>& optional) const;
  void write_list() const;

  std::string folder_;
  OutputFolder place_;
  std::vector<OutputFile> earlier_;
  std::vector<std::string> planned_, announced_;  ///< relative to the folder
  bool begun_ = false;
};

}  // namespace xgm
