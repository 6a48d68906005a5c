// SPDX-License-Identifier: Apache-2.0
// What run.json says, as tables. A record may lack anything: what is not there is not shown.
#pragma once

#include <string>

#include "report/encode.hpp"

namespace xgm::report {

/// NaN if there is no such number.
double number_at(const Json& record, const std::string& pointer);
/// "" if there is no such text.
std::string text_at(const Json& record, const std::string& pointer);

/// Total error at a threshold, 0 to 1, in the region by which benchmarks rank: non-occluded where
/// it is known. NaN without truth.
double total_error(const Json& record, double delta);
double average_error(const Json& record);

/// Size, coverage, errors, time and memory in a few words.
std::string facts_html(const Json& record);
/// Regions against the figures of each; "" without truth.
std::string evaluation_html(const Json& record);
/// Pipeline, command line, versions, input files.
std::string configuration_html(const Json& record);
std::string warnings_html(const Json& record);

}  // namespace xgm::report
