// SPDX-License-Identifier: Apache-2.0
// Pieces of HTML.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/palette.hpp"

namespace xgm::report {

/// "–" for what is not finite.
std::string number(double value, int decimals);
std::string percent(double share);
std::string seconds(double value);
std::string megabytes(double bytes);

using Row = std::vector<std::string>;  ///< cells, HTML already
/// The first column names the row; numbers stand to the right in all others.
std::string table(const Row& head, const std::vector<Row>& rows);

/// Whether values above a ramp's span are to be expected.
enum class Above { rarely, often };

/// A bar of the ramp with the numbers that belong to its colours, and the colour of `missing`.
std::string ramp_legend(const Ramp& ramp, const Span& span, const std::string& unit,
                        const std::string& missing, Above above = Above::rarely);
/// Classes with their shares, 0 to 1, if there are any.
std::string class_legend(const std::vector<Class>& classes, const std::vector<double>& shares);

struct Picture {
  std::string title;   ///< text
  std::string uri;     ///< data: ...
  std::string legend;  ///< HTML
  std::string id{};
};
std::string figure(const Picture& picture);

/// Names and values, as text.
std::string facts_list(const std::vector<std::pair<std::string, std::string>>& facts);

std::string details(const std::string& summary, const std::string& content);

}  // namespace xgm::report
