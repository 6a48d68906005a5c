// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/camera/write_rpc.hpp"

#include <array>
#include <charconv>

namespace xgm::geo {
namespace {

std::string exact(double value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

void add(std::string& text, const std::string& key, double value) {
  text += key + ": " + exact(value) + "\n";
}

void add(std::string& text, const std::string& key, const RpcPolynomial& polynomial) {
  for (std::size_t i = 0; i < polynomial.size(); ++i) {
    add(text, key + "_COEFF_" + std::to_string(i + 1), polynomial[i]);
  }
}

}  // namespace

std::string rpc_text(const RpcModel& model) {
  struct Named {
    const char* name;
    const RpcAxis& axis;
  };
  const std::array<Named, 5> axes{{{"LINE", model.row},
                                   {"SAMP", model.column},
                                   {"LAT", model.latitude},
                                   {"LONG", model.longitude},
                                   {"HEIGHT", model.height}}};
  std::string text;
  for (const auto& [name, axis] : axes) add(text, std::string(name) + "_OFF", axis.offset);
  for (const auto& [name, axis] : axes) add(text, std::string(name) + "_SCALE", axis.scale);
  add(text, "LINE_NUM", model.row_ratio.numerator);
  add(text, "LINE_DEN", model.row_ratio.denominator);
  add(text, "SAMP_NUM", model.column_ratio.numerator);
  add(text, "SAMP_DEN", model.column_ratio.denominator);
  return text;
}

}  // namespace xgm::geo
