// SPDX-License-Identifier: Apache-2.0
// Files in XML, by GDAL's parser.
#pragma once

#include <cpl_minixml.h>

#include <memory>
#include <string>
#include <string_view>

namespace xgm::geo {

struct DestroyXml {
  void operator()(CPLXMLNode* node) const { CPLDestroyXMLNode(node); }
};
using XmlPtr = std::unique_ptr<CPLXMLNode, DestroyXml>;

/// Throws Error, which names the file.
XmlPtr parse_xml_file(const std::string& file);

inline bool is_element(const CPLXMLNode* node, std::string_view name) {
  return node->eType == CXT_Element && node->pszValue == name;
}

}  // namespace xgm::geo
