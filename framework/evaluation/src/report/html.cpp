// SPDX-License-Identifier: Apache-2.0
#include "report/html.hpp"

#include <cmath>

#include "xgm/base/json.hpp"
#include "xgm/base/text.hpp"
#include "xgm/evaluation/report.hpp"

namespace xgm {

std::string html_text(const std::string& text) {
  // The writer of JSON replaces what is no UTF-8; quotes and escapes are taken off again.
  const std::string sound = Json::parse(Json(text).dump()).text();
  std::string escaped;
  for (const char c : sound) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

namespace report {

std::string number(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  return fixed_number(value, decimals);
}

std::string percent(double share) {
  return std::isfinite(share) ? number(100 * share, 2) + " %" : "–";
}

std::string seconds(double value) { return number(value, value < 10 ? 3 : 1) + " s"; }

std::string megabytes(double bytes) { return number(bytes / 1e6, bytes < 1e7 ? 1 : 0) + " MB"; }

std::string table(const Row& head, const std::vector<Row>& rows) {
  std::string html = "<div class=\"scroll\"><table><thead><tr>";
  for (const std::string& cell : head) html += "<th scope=\"col\">" + cell + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const Row& row : rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      html += i == 0 ? "<th scope=\"row\">" + row[i] + "</th>" : "<td>" + row[i] + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string ramp_legend(const Ramp& ramp, const Span& span, const std::string& unit,
                        const std::string& missing, Above above) {
  constexpr int kStops = 16;
  constexpr int kTicks = 4;
  std::string stops, ticks;
  for (int i = 0; i <= kStops; ++i) {
    stops += (i > 0 ? "," : "") + css(ramp[static_cast<std::size_t>(255 * i / kStops)]);
  }
  const double width = span.high - span.low;
  const int decimals = width < 0.1 ? 3 : width < 1 ? 2 : width < 10 ? 1 : 0;
  for (int i = 0; i <= kTicks; ++i) {
    const double value = span.low + (span.high - span.low) * i / kTicks;
    const bool is_last = i == kTicks;
    ticks += std::string("<span>") + (is_last && above == Above::often ? "≥ " : "") +
             number(value, decimals) + (is_last ? unit : "") + "</span>";
  }
  return "<div class=\"legend\"><div class=\"bar\" style=\"background:linear-gradient(90deg," +
         stops + ")\"></div><div class=\"ticks\">" + ticks + "</div>" +
         class_legend({{missing, kNoNumber}}, {}) + "</div>";
}

std::string class_legend(const std::vector<Class>& classes, const std::vector<double>& shares) {
  std::string html = "<ul class=\"classes\">";
  for (std::size_t i = 0; i < classes.size(); ++i) {
    html += "<li><span class=\"swatch\" style=\"background:" + css(classes[i].colour) +
            "\"></span>" + html_text(classes[i].name);
    if (i < shares.size()) html += " <b>" + percent(shares[i]) + "</b>";
    html += "</li>";
  }
  return html + "</ul>";
}

std::string figure(const Picture& picture) {
  const std::string title = html_text(picture.title);
  const std::string id = picture.id.empty() ? "" : " id=\"" + picture.id + "\"";
  return "<figure><img" + id + " alt=\"" + title + "\" src=\"" + picture.uri +
         "\"><figcaption><b>" + title + "</b>" + picture.legend + "</figcaption></figure>\n";
}

std::string facts_list(const std::vector<std::pair<std::string, std::string>>& facts) {
  std::string html = "<dl class=\"facts\">";
  for (const auto& [name, value] : facts) {
    html += "<div><dt>" + html_text(name) + "</dt><dd>" + html_text(value) + "</dd></div>";
  }
  return html + "</dl>\n";
}

std::string details(const std::string& summary, const std::string& content) {
  return "<details><summary>" + html_text(summary) + "</summary>\n" + content + "</details>\n";
}

}  // namespace report
}  // namespace xgm
