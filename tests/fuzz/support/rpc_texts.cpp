// SPDX-License-Identifier: Apache-2.0
#include "fuzz/support/rpc_texts.hpp"

#include <cmath>

#include "fuzz/support/target.hpp"
#include "support/sample_camera.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/camera/read_rpc.hpp"
#include "xgm/geo/camera/write_rpc.hpp"

namespace xgm::fuzz {
namespace {

using geo::RpcAxis;
using geo::RpcModel;

std::vector<double> numbers_of(const RpcModel& model) {
  std::vector<double> all;
  for (const RpcAxis& axis :
       {model.column, model.row, model.longitude, model.latitude, model.height}) {
    require(axis.scale != 0, "no scale is 0");
    all.insert(all.end(), {axis.offset, axis.scale});
  }
  for (const geo::RpcRatio& ratio : {model.column_ratio, model.row_ratio}) {
    all.insert(all.end(), ratio.numerator.begin(), ratio.numerator.end());
    all.insert(all.end(), ratio.denominator.begin(), ratio.denominator.end());
  }
  return all;
}

}  // namespace

void check_cameras(const std::vector<RpcModel>& models) {
  static const testing::TemporaryFolder folder;
  require(!models.empty(), "there is a camera or an error");
  for (const RpcModel& model : models) {
    const std::vector<double> numbers = numbers_of(model);
    for (const double number : numbers) require(std::isfinite(number), "a number is finite");
    const auto again = geo::read_rpc(folder.write("again_RPC.TXT", geo::rpc_text(model)));
    require(again.size() == 1 && numbers_of(again.front()) == numbers,
            "a camera that was written and read is the same");
  }
}

std::string sample_text() { return geo::rpc_text(testing::sample_camera()); }

std::vector<std::string> rpc_words() {
  return {"LINE_OFF", "samp_scale", "lineOffset",    "sampNumCoef", "lineDenCoef",
          "LAT_",     "LONG_",      "HEIGHT_",       "COEFF_20",    "_NUM",
          "_DEN",     ": ",         " = (",          ");",          ",",
          "1e308",    "1e999",      "1e-400",        "-inf",        "nan",
          "+0",       "-.",         "0x1p3",         "pixels",      "\r\n",
          "\t",       "2147483648", "00000000000001"};
}

}  // namespace xgm::fuzz
