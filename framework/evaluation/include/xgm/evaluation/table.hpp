// SPDX-License-Identifier: Apache-2.0
// Tables of figures, before they are written in one format or another.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

struct TableCell {
  std::string text;
  bool best = false;
};

/// The first `names` columns are names, the others figures.
struct Table {
  std::string title;
  std::size_t names = 1;
  std::vector<std::string> header;
  std::vector<std::vector<TableCell>> rows{};
  std::vector<std::string> notes{};  ///< what went wrong in it
};

inline constexpr const char* kNoFigure = "–";

/// `value` with so many decimals; kNoFigure for what is not finite.
XGM_API std::string figure_text(double value, int decimals);

enum class Best { lowest, highest, none };
/// Marks the best of each column of figures among `rows`, if there are several. What looks the same
/// is the same.
XGM_API void mark_best(const std::vector<std::vector<TableCell>*>& rows, std::size_t names,
                       const std::vector<Best>& columns);

/// For terminals; the best of a column has a star.
XGM_API std::string table_text(const Table& table);
/// Under a heading; the best of a column is bold.
XGM_API std::string table_markdown(const Table& table);
/// A fragment of an HTML page, which wants kTableStyle before it.
XGM_API std::string table_html(const Table& table);
XGM_API extern const char* const kTableStyle;

/// What means something to Markdown, or to the HTML in it, means nothing.
XGM_API std::string markdown_text(const std::string& text);
/// A field of CSV, quoted if need be (RFC 4180).
XGM_API std::string csv_field(const std::string& text);
/// A figure in CSV; empty for what is not finite.
XGM_API std::string csv_number(double value);

}  // namespace xgm
