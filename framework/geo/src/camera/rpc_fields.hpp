// SPDX-License-Identifier: Apache-2.0
// The values of an RPC model by their names, which each format spells its own way.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "xgm/geo/camera/rpc_model.hpp"

namespace xgm::geo {

class RpcFields {
 public:
  /// `file` is named in errors.
  explicit RpcFields(std::string file) : file_(std::move(file)) {}

  /// One value or a list of them: "LINE_OFF", "sampNumCoef", "row_den", "line_num_coeff_07". Names
  /// of other things are ignored.
  void add(std::string_view key, std::string_view text);
  bool empty() const { return values_.empty(); }

  /// `first_pixel`: what the format calls the centre of the first pixel. Throws Error if anything
  /// is missing.
  RpcModel model(double first_pixel = 0) const;

 private:
  const std::vector<double>& values(const std::string& name, std::size_t count) const;
  RpcAxis axis(const std::string& name) const;
  RpcRatio ratio(const std::string& name) const;

  std::string file_;
  std::map<std::string, std::vector<double>> values_;  // "line_off", "samp_num"
};

}  // namespace xgm::geo
