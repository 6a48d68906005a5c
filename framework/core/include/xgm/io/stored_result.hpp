// SPDX-License-Identifier: Apache-2.0
// The result of a matcher in files, for runs that go on later: maps, and last NAME.json, which says
// that they are complete, by their hashes, and what question they answer.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/base/json.hpp"
#include "xgm/data/match.hpp"

namespace xgm {

enum class StoredState {
  missing,   ///< there is none, or one of another question
  damaged,   ///< its files are not as they were written
  complete,  ///< ready to be read
};

/// `question`: a hash of all that decides of the result.
XGM_API StoredState state_of_result(const std::string& folder, const std::string& name,
                                    const std::string& question);

/// Writes NAME.pfm and so on (write_stored_map), NAME_reverse.pfm and so on if there is a reverse
/// map, and NAME.json, into which `more` goes, too. The folder is there. All is on the disk then.
/// Written again, or by two processes at once, it is the same bytes. Throws Error; nothing that is
/// half-written counts as complete.
XGM_API void write_result(const std::string& folder, const std::string& name,
                          const std::string& question, const MatchResult& result,
                          const Json& more = Json::object());

/// NAME.json alone, for files of these names that are in the folder.
XGM_API void write_record(const std::string& folder, const std::string& name,
                          const std::string& question, const std::vector<std::string>& files,
                          const Json& more = Json::object());

/// Of one that is complete. Throws Error.
XGM_API MatchResult read_result(const std::string& folder, const std::string& name);

}  // namespace xgm
