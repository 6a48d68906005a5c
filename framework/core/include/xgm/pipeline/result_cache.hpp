// SPDX-License-Identifier: Apache-2.0
// What matchers have found, kept from one run to the next: if only what comes after matching is
// changed, nothing is matched again.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/stage/kept_results.hpp"

namespace xgm {

class ResultFolder;

/// Any number of runs may use one folder at once. It has no state beside its files: runs that are
/// ended at any moment do it no harm. What cannot be kept or read is no failure of a run.
class XGM_API ResultCache final : public KeptResults {
 public:
  using Tell = std::function<void(const std::string&)>;

  /// The folder is made if it is missing, and holds `bytes` at most: what was not used for the
  /// longest time is removed first. `question`: see question_of_matcher(). `tell` is told of what
  /// goes wrong. Throws UsageError if the folder cannot be written to.
  ResultCache(const std::string& folder, std::uint64_t bytes, const Json& question, Tell tell);
  ~ResultCache() override;

  std::optional<MatchResult> find(const std::string& name) override;
  void keep(const std::string& name, const MatchResult& result) override;
  /// Of the part's matcher.
  std::shared_ptr<KeptResults> of_part(const std::string& name) override;

  /// The names of the results that were found.
  const std::vector<std::string>& reused() const;

 private:
  void trim() const;

  std::unique_ptr<ResultFolder> results_;
  std::uint64_t limit_;
  Tell tell_;
  bool is_writable_ = true;
};

}  // namespace xgm
