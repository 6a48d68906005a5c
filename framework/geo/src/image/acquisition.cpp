// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/image/acquisition.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <vector>

#include "ground/gdal.hpp"
#include "ground/xml.hpp"
#include "xgm/base/error.hpp"

namespace xgm::geo {
namespace {

/// Texts by their names, in capitals and without underscores: "MEANSUNAZ". The first one counts.
class Texts {
 public:
  void add(std::string_view name, std::string_view text, bool replace = false) {
    std::string plain;
    for (const char c : name) {
      if (c != '_') plain += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    const auto [place, is_new] = texts_.try_emplace(plain, text);
    if (!is_new && replace) place->second = text;
  }
  /// Empty if there is none.
  std::string text(std::initializer_list<const char*> names) const {
    for (const char* name : names) {
      if (const auto found = texts_.find(name); found != texts_.end()) return found->second;
    }
    return {};
  }
  /// A number within [low, high].
  std::optional<double> number(std::initializer_list<const char*> names, double low,
                               double high) const {
    const std::string found = text(names);
    const std::size_t begin = found.find_first_not_of(" \"+");
    double value = 0;
    if (begin == std::string::npos ||
        std::from_chars(found.data() + begin, found.data() + found.size(), value).ec !=
            std::errc() ||
        !(value >= low && value <= high)) {
      return std::nullopt;
    }
    return value;
  }

 private:
  std::map<std::string, std::string> texts_;
};

/// "2014-06-19T18:52:50.787577Z", "20021216151629".
std::optional<double> seconds_since_1970(const std::string& text) {
  std::string digits;
  std::size_t i = 0;
  for (; i < text.size() && digits.size() < 14; ++i) {
    if (std::isdigit(static_cast<unsigned char>(text[i])) != 0) digits += text[i];
  }
  if (digits.size() < 14) return std::nullopt;
  const auto part = [&](std::size_t begin, std::size_t count) {
    return std::stoi(digits.substr(begin, count));
  };
  using namespace std::chrono;
  const year_month_day date(year(part(0, 4)), month(static_cast<unsigned>(part(4, 2))),
                            day(static_cast<unsigned>(part(6, 2))));
  if (!date.ok() || part(8, 2) > 24 || part(10, 2) > 59 || part(12, 2) > 60) return std::nullopt;
  double fraction = 0;
  if (i < text.size() && text[i] == '.') {
    std::from_chars(text.data() + i, text.data() + text.size(), fraction);
  }
  return static_cast<double>(sys_days(date).time_since_epoch().count()) * 86400 +
         part(8, 2) * 3600 + part(10, 2) * 60 + part(12, 2) + fraction;
}

Acquisition from_texts(const Texts& texts) {
  Acquisition result;
  result.time = seconds_since_1970(texts.text({"FIRSTLINETIME", "TLCTIME", "NITFIDATIM"}));
  if (!result.time) {
    result.time = seconds_since_1970(texts.text({"IMAGINGDATE"}) + texts.text({"IMAGINGTIME"}));
  }
  result.sun_azimuth = texts.number({"MEANSUNAZ", "SUNAZIMUTH", "SUNAZ"}, 0, 360);
  result.sun_elevation = texts.number({"MEANSUNEL", "SUNELEVATION", "SUNEL"}, -90, 90);
  result.cloud_cover = texts.number({"CLOUDCOVER"}, 0, 1);
  if (!result.cloud_cover) {
    const auto percent = texts.number({"CLOUDCOVERAGE", "CLOUDCVR"}, 0, 100);
    if (percent) result.cloud_cover = *percent / 100;
  }
  return result;
}

/// Every element with a text. DIMAP gives angles for several places; those of the centre replace
/// the others.
void add_elements(const CPLXMLNode& parent, bool replace, Texts& texts) {
  for (const CPLXMLNode* child = parent.psChild; child != nullptr; child = child->psNext) {
    if (child->eType != CXT_Element) continue;
    const char* const text = CPLGetXMLValue(child, nullptr, nullptr);
    if (text != nullptr && *text != '\0') texts.add(child->pszValue, text, replace);
    const bool centre = std::string_view(CPLGetXMLValue(child, "LOCATION_TYPE", "")) == "Center";
    add_elements(*child, replace || centre, texts);
  }
}

void add_xml(const std::string& file, Texts& texts) {
  const XmlPtr document = parse_xml_file(file);
  for (const CPLXMLNode* node = document.get(); node != nullptr; node = node->psNext) {
    if (node->eType == CXT_Element && node->pszValue[0] != '?') add_elements(*node, false, texts);
  }
}

/// "key = value;" line by line.
void add_imd(const std::string& file, Texts& texts) {
  std::ifstream stream(file);
  if (!stream) throw Error(file + ": there is no such file of metadata");
  std::string line;
  while (std::getline(stream, line) && line.size() < 10000) {
    const std::size_t equals = line.find('=');
    const std::size_t begin = line.find_first_not_of(" \t");
    if (equals == std::string::npos || begin == equals) continue;
    const std::size_t end = line.find_last_not_of(" \t", equals - 1);
    const std::size_t value = line.find_first_not_of(" \t\"", equals + 1);
    if (value == std::string::npos) continue;
    texts.add(std::string_view(line).substr(begin, end - begin + 1),
              std::string_view(line).substr(value, line.find_last_not_of("; \t\r\"") + 1 - value));
  }
}

/// What GDAL reads out of the image, and of an .IMD beside it.
void add_image(const std::string& file, Texts& texts) {
  const DatasetPtr dataset = open_raster(file);
  const QuietGdal quiet;
  for (const char* domain : {"", "IMD"}) {
    char** entry = dataset->GetMetadata(domain);
    for (; entry != nullptr && *entry != nullptr; ++entry) {
      const std::string_view text(*entry);
      const std::size_t equals = text.find('=');
      if (equals == std::string_view::npos) continue;
      const std::size_t dot = text.substr(0, equals).rfind('.');  // "IMAGE_1.meanSunAz"
      const std::size_t begin = dot == std::string_view::npos ? 0 : dot + 1;
      texts.add(text.substr(begin, equals - begin), text.substr(equals + 1));
    }
  }
  char** const tres = dataset->GetMetadata("xml:TRE");
  if (tres == nullptr || *tres == nullptr) return;
  const XmlPtr document(CPLParseXMLString(*tres));
  if (document == nullptr) return;
  // <field name="SUN_EL" value="+43.5"/>
  std::vector<const CPLXMLNode*> open{document.get()};
  while (!open.empty()) {
    const CPLXMLNode* const node = open.back();
    open.pop_back();
    for (const CPLXMLNode* next = node; next != nullptr; next = next->psNext) {
      if (is_element(next, "field")) {
        texts.add(CPLGetXMLValue(next, "name", ""), CPLGetXMLValue(next, "value", ""));
      } else if (next->psChild != nullptr) {
        open.push_back(next->psChild);
      }
    }
  }
}

bool has_ending(const std::string& file, std::string ending) {
  std::string own = std::filesystem::path(file).extension().string();
  std::ranges::transform(own, own.begin(), [](unsigned char c) { return std::tolower(c); });
  return own == ending;
}

void add_file(const std::string& file, Texts& texts) {
  if (has_ending(file, ".xml")) {
    add_xml(file, texts);
  } else if (has_ending(file, ".imd")) {
    add_imd(file, texts);
  } else {
    add_image(file, texts);
  }
}

/// DIM_<name>.XML of RPC_<name>.XML and IMG_<name>.TIF; <name>.IMD and <name>.XML of <name>.TIF.
void add_beside(const std::string& file, std::vector<std::string>& candidates) {
  const std::filesystem::path path(file), folder = path.parent_path();
  const std::string name = path.stem().string();
  for (const char* ending : {".IMD", ".imd", ".XML", ".xml"}) {
    candidates.push_back((folder / (name + ending)).string());
  }
  if (name.starts_with("RPC_") || name.starts_with("IMG_")) {
    candidates.push_back((folder / ("DIM_" + name.substr(4) + ".XML")).string());
  }
}

}  // namespace

Acquisition read_acquisition(const std::string& file) {
  Texts texts;
  add_file(file, texts);
  return from_texts(texts);
}

Acquisition find_acquisition(const std::string& image_file, const std::string& camera_file) {
  std::vector<std::string> candidates;
  if (!camera_file.empty()) {
    if (has_ending(camera_file, ".xml")) candidates.push_back(camera_file);
    add_beside(camera_file, candidates);
  }
  candidates.push_back(image_file);
  add_beside(image_file, candidates);
  Acquisition result;
  const auto take = [](std::optional<double>& value, const std::optional<double>& other) {
    if (!value) value = other;
  };
  for (const std::string& file : candidates) {
    if (!std::filesystem::exists(file)) continue;
    Acquisition found;
    try {
      found = read_acquisition(file);
    } catch (const Error&) {
      continue;  // not a file of metadata; the values stay unknown
    }
    take(result.time, found.time);
    take(result.sun_azimuth, found.sun_azimuth);
    take(result.sun_elevation, found.sun_elevation);
    take(result.cloud_cover, found.cloud_cover);
  }
  return result;
}

}  // namespace xgm::geo
