// SPDX-License-Identifier: Apache-2.0
#include "camera/rpc_fields.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "xgm/base/error.hpp"

namespace xgm::geo {
namespace {

using Spelling = std::pair<std::string_view, std::string_view>;
constexpr std::array<Spelling, 10> kAxes{{{"line", "line"},
                                          {"row", "line"},
                                          {"sample", "samp"},
                                          {"samp", "samp"},
                                          {"col", "samp"},
                                          {"lat", "lat"},
                                          {"long", "long"},
                                          {"lon", "long"},
                                          {"height", "height"},
                                          {"alt", "height"}}};
constexpr std::array<Spelling, 7> kQuantities{{{"off", "off"},
                                               {"offset", "off"},
                                               {"scale", "scale"},
                                               {"num", "num"},
                                               {"numcoef", "num"},
                                               {"den", "den"},
                                               {"dencoef", "den"}}};

/// "line_num" for LINE_NUM_COEFF_7.
struct Name {
  std::string name;
  bool is_numbered = false;  ///< one value of a list, in its order
};

std::optional<Name> canonical(std::string_view key) {
  std::string plain;
  for (const char c : key) {
    if (c != '_') plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  const std::size_t digits = plain.find_last_not_of("0123456789") + 1;
  const bool numbered = digits < plain.size();
  plain.resize(digits);
  if (plain.ends_with("coeff")) plain.pop_back();  // COEFF and Coef are the same
  for (const auto& [axis, axis_name] : kAxes) {
    for (const auto& [quantity, quantity_name] : kQuantities) {
      if (plain == std::string(axis) + std::string(quantity)) {
        return Name{std::string(axis_name) + "_" + std::string(quantity_name), numbered};
      }
    }
  }
  return std::nullopt;
}

/// All numbers of a text; commas, brackets and units between them are passed over.
std::vector<double> numbers(std::string_view text) {
  std::vector<double> found;
  while (!text.empty()) {
    const std::size_t begin = text.find_first_of("+-.0123456789");
    if (begin == std::string_view::npos) break;
    text.remove_prefix(begin + (text[begin] == '+' ? 1 : 0));
    double value = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end.ec == std::errc::invalid_argument) {  // a sign or a full stop alone
      text.remove_prefix(std::min<std::size_t>(1, text.size()));
      continue;
    }
    if (end.ec != std::errc()) value = std::numeric_limits<double>::infinity();  // too large
    found.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end.ptr - text.data()));
  }
  return found;
}

}  // namespace

void RpcFields::add(std::string_view key, std::string_view text) {
  const auto name = canonical(key);
  if (!name) return;
  std::vector<double> read = numbers(text);
  std::vector<double>& list = values_[name->name];
  if (!name->is_numbered) list.clear();
  list.insert(list.end(), read.begin(), read.end());
}

const std::vector<double>& RpcFields::values(const std::string& name, std::size_t count) const {
  const auto found = values_.find(name);
  if (found == values_.end()) {
    throw Error(file_ + ": the RPC model has no " + name + "; it is incomplete");
  }
  const std::vector<double>& list = found->second;
  const bool sound =
      list.size() == count && std::ranges::all_of(list, [](double v) { return std::isfinite(v); });
  if (!sound) {
    throw Error(file_ + ": " + name + " of the RPC model must be " + std::to_string(count) +
                (count == 1 ? " number" : " numbers"));
  }
  return list;
}

RpcAxis RpcFields::axis(const std::string& name) const {
  const RpcAxis axis{values(name + "_off", 1).front(), values(name + "_scale", 1).front()};
  if (axis.scale == 0) throw Error(file_ + ": " + name + "_scale of the RPC model is 0");
  return axis;
}

RpcRatio RpcFields::ratio(const std::string& name) const {
  RpcRatio ratio;
  std::ranges::copy(values(name + "_num", 20), ratio.numerator.begin());
  std::ranges::copy(values(name + "_den", 20), ratio.denominator.begin());
  return ratio;
}

RpcModel RpcFields::model(double first_pixel) const {
  RpcModel model{.column = axis("samp"),
                 .row = axis("line"),
                 .longitude = axis("long"),
                 .latitude = axis("lat"),
                 .height = axis("height"),
                 .column_ratio = ratio("samp"),
                 .row_ratio = ratio("line")};
  model.column.offset -= first_pixel;
  model.row.offset -= first_pixel;
  return model;
}

}  // namespace xgm::geo
