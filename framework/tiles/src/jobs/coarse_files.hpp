// SPDX-License-Identifier: Apache-2.0
// The coarse maps in files: strips of rows, each a result of its own, so that a tile checks and
// reads no more than it needs.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "coarse_maps.hpp"
#include "jobs/job_files.hpp"

namespace xgm::tiles {

/// Writes the strips and, last, the record of the job. `strip`: rows of each, at least 1. Throws
/// Error.
void write_coarse(const JobManifest& manifest, const TileJob& job, const MatchResult& maps,
                  int strip, double seconds);

struct CoarseState {
  StoredState state = StoredState::missing;
  std::string file;  ///< the record that is missing, or damaged with what it names
};

/// Of the record of the job, and of the strips that hold rows of `rows`.
CoarseState state_of_coarse(const JobManifest& manifest, const TileJob& job,
                            cv::Range rows = cv::Range::all());

/// The strips that hold them. The scale is that of the maps. Throws Error.
CoarseMaps read_coarse(const JobManifest& manifest, const TileJob& job, cv::Range rows, int scale);

}  // namespace xgm::tiles
