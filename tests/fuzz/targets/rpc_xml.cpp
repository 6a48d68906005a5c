// SPDX-License-Identifier: Apache-2.0
// RPC cameras in vendors' XML: DIMAP 1 to 3, DigitalGlobe, EnMAP.
#include "fuzz/support/rpc_texts.hpp"
#include "fuzz/support/target.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/camera/read_rpc.hpp"

namespace xgm::fuzz {
namespace {

std::string element(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name + ">";
}

std::string twenty(const std::string& before = "", const std::string& after = " ") {
  std::string text;
  for (int i = 1; i <= 20; ++i) {
    const std::string number = before.empty() ? "" : std::to_string(i);
    const auto name = [&](std::string tag) {
      const std::size_t at = tag.find('#');
      return at == std::string::npos ? tag : tag.replace(at, 1, number);
    };
    text += name(before) + "1.5E-0" + std::to_string(i % 10) + name(after);
  }
  return text;
}

std::string numbered(const std::string& name) {
  return twenty("<" + name + "_#>", "</" + name + "_#>");
}

std::string axes(std::initializer_list<const char*> names, const std::string& offset,
                 const std::string& scale) {
  std::string text;
  for (const std::string name : names) {
    text += element(name + offset, "12.5") + element(name + scale, "1.5");
  }
  return text;
}

std::string dimap(const std::string& block) {
  const std::string coefficients = numbered("SAMP_NUM_COEFF") + numbered("SAMP_DEN_COEFF") +
                                   numbered("LINE_NUM_COEFF") + numbered("LINE_DEN_COEFF");
  return element(
      "Dimap_Document",
      element("Rational_Function_Model",
              element("Global_RFM",
                      element(block, coefficients) +
                          element("RFM_Validity", axes({"LONG", "LAT", "HEIGHT", "SAMP", "LINE"},
                                                       "_OFF", "_SCALE")))));
}

std::string dimap1() {
  std::string sensor;
  for (const char* axis : {"Lon", "Lat", "Alt", "Col", "Row"}) {
    sensor += element(axis, element("A", "1.5") + element("B", "12.5"));
  }
  sensor += element("Inverse_Model",
                    element("F_COL", twenty() + twenty()) + element("F_ROW", twenty() + twenty()));
  return element("Dimap_Document", element("Rational_Sensor_Model", element("Global_RFM", sensor)) +
                                       element("Global_RFM", sensor));
}

std::string digital_globe() {
  std::string lists;
  for (const char* list : {"LINENUMCOEF", "LINEDENCOEF", "SAMPNUMCOEF", "SAMPDENCOEF"}) {
    lists += element(std::string(list) + "List", element(list, twenty()));
  }
  return element("isd",
                 element("RPB", element("IMAGE", axes({"LINE", "SAMP", "LAT", "LONG", "HEIGHT"},
                                                      "OFFSET", "SCALE") +
                                                     lists)));
}

std::string enmap() {
  return element("level_X",
                 element("RPC", element("bandID", axes({"ROW", "COL", "LAT", "LONG", "HEIGHT"},
                                                       "_OFF", "_SCALE") +
                                                      numbered("ROW_NUM") + numbered("ROW_DEN") +
                                                      numbered("COL_NUM") + numbered("COL_DEN"))));
}

}  // namespace

void check(std::string_view input) {
  static const testing::TemporaryFolder folder;
  const std::string file = folder.write("camera.XML", std::string(input));
  std::vector<geo::RpcModel> models;
  if (accepts("camera.XML", [&] { models = geo::read_rpc(file); })) check_cameras(models);
}

std::vector<std::string> seeds() {
  return {dimap("Inverse_Model"), dimap("GroundtoImage_Values"), dimap1(), digital_globe(),
          enmap()};
}

std::vector<std::string> words() {
  std::vector<std::string> words = rpc_words();
  for (const char* word : {"<Dimap_Document>",
                           "<Global_RFM>",
                           "<RFM_Validity>",
                           "<Inverse_Model>",
                           "<isd>",
                           "<RPB>",
                           "<level_X>",
                           "<RPC>",
                           "<Rational_Sensor_Model>",
                           "<A>",
                           "<B>",
                           "F_COL",
                           "</",
                           "/>",
                           "<!--",
                           "-->",
                           "<![CDATA[",
                           "]]>",
                           "<?xml version=\"1.0\"?>",
                           "&lt;",
                           "&#0;",
                           " a=\"1\""}) {
    words.emplace_back(word);
  }
  return words;
}

}  // namespace xgm::fuzz
