// SPDX-License-Identifier: Apache-2.0
#include "camera/rpc_metadata.hpp"

#include <sstream>

#include "xgm/geo/camera/write_rpc.hpp"

namespace xgm::geo {

std::map<std::string, std::string> rpc_metadata(const RpcModel& model) {
  // The same keys as in the text, but for the coefficients, which share one key.
  std::map<std::string, std::string> fields;
  std::istringstream lines(rpc_text(model));
  for (std::string key, value; lines >> key >> value;) {
    key.pop_back();  // the colon
    const std::size_t coefficient = key.find("_COEFF_");
    std::string& field =
        fields[key.substr(0, coefficient == std::string::npos ? coefficient : coefficient + 6)];
    field += (field.empty() ? "" : " ") + value;
  }
  return fields;
}

}  // namespace xgm::geo
