// SPDX-License-Identifier: Apache-2.0
// What is done of a run that may be cut short at any moment, so that another one goes on from
// there.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/stage/kept_results.hpp"

namespace xgm {

class ResultFolder;

/// Keeps results in a folder of its own until the run has ended well. One run at a time.
class XGM_API UnfinishedRun final : public KeptResults {
 public:
  struct Options {
    /// Go on from what is in the folder, and keep all from the beginning on. Without it, the folder
    /// is emptied, and kept is what costs little beside the run:
    bool resume = false;
    double after_seconds = 5;  ///< what is done from then on,
    double share = 0.02;       ///< and is written in this share of the time of the run so far
    /// Told of results that are damaged.
    std::function<void(const std::string&)> tell = [](const std::string&) {};
  };

  /// `question`: see question_of(). Throws UsageError if a run of another question is to be gone on
  /// with, or if the folder holds something else.
  UnfinishedRun(const std::string& folder, Json question, Options options);
  ~UnfinishedRun() override;

  std::optional<MatchResult> find(const std::string& name) override;
  void keep(const std::string& name, const MatchResult& result) override;
  std::optional<DisparityMap> find_part(const std::string& name) override;
  void keep_part(const std::string& name, const DisparityMap& part) override;
  Json decided(const std::string& what, const std::function<Json()>& decide) override;

  /// The names of the results that were found.
  const std::vector<std::string>& reused() const;
  /// The run has ended well: removes the folder.
  void remove();

 private:
  void take_up();
  void write_question() const;
  bool is_cheap(const MatchResult& result) const;

  Json question_;
  Json decisions_ = Json::object();
  Options options_;
  std::unique_ptr<ResultFolder> results_;
  std::chrono::steady_clock::time_point begin_;
  bool is_there_ = false;  ///< the folder
};

}  // namespace xgm
