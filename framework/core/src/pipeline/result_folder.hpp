// SPDX-License-Identifier: Apache-2.0
// Results of runs in a folder, found by their question and their name in the run.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "xgm/data/match.hpp"

namespace xgm {

class ResultFolder {
 public:
  using Tell = std::function<void(const std::string&)>;

  /// `question`: a hash. The folder need not be there before something is written. `tell` is told
  /// of results that are damaged.
  ResultFolder(std::string folder, std::string question, Tell tell)
      : folder_(std::move(folder)), question_(std::move(question)), tell_(std::move(tell)) {}

  const std::string& path() const { return folder_; }
  /// The files of a result begin with this.
  std::string id(const std::string& name) const;

  /// None if it is missing or damaged; what is damaged is removed.
  std::optional<MatchResult> find(const std::string& name);
  /// Throws Error.
  void write(const std::string& name, const MatchResult& result) const;

  /// The names of the results that were found.
  const std::vector<std::string>& found() const { return found_; }

 private:
  std::string folder_, question_;
  Tell tell_;
  std::vector<std::string> found_{};
};

}  // namespace xgm
