// SPDX-License-Identifier: Apache-2.0
// RPC cameras from the files that vendors and tools deliver.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/geo/camera/rpc_model.hpp"

namespace xgm::geo {

/// The models in a file, by what it is:
/// - images: GeoTIFF tags, NITF (RPC00B), and the files beside them that GDAL knows (_RPC.TXT,
/// .RPB,
///   DIMAP);
/// - *.XML: DIMAP 1, 2 (SPOT, Pleiades) and 3 (Pleiades Neo), DigitalGlobe with an RPB block,
/// EnMAP;
/// - text: "KEY: value" (_RPC.TXT, .geom of OTB), .RPB, and dictionaries in YAML or JSON.
/// One model, or one per band (EnMAP). All have pixel (0, 0) at the centre of the first pixel.
/// Throws Error, which names the file, if it holds no model, or one that is incomplete or no
/// number.
XGM_API std::vector<RpcModel> read_rpc(const std::string& file);

/// The same for an image: empty if nothing is wrong with it but that it has no RPC.
XGM_API std::vector<RpcModel> read_rpc_of_image(const std::string& file);

}  // namespace xgm::geo
