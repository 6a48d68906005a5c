// SPDX-License-Identifier: Apache-2.0
#include "ground/xml.hpp"

#include "ground/gdal.hpp"
#include "xgm/base/error.hpp"

namespace xgm::geo {

XmlPtr parse_xml_file(const std::string& file) {
  const QuietGdal quiet;
  XmlPtr document(CPLParseXMLFile(file.c_str()));
  if (document == nullptr) throw Error(file + ": is no XML: " + QuietGdal::message());
  return document;
}

}  // namespace xgm::geo
