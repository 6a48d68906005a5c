// SPDX-License-Identifier: Apache-2.0
#include <yaml-cpp/yaml.h>

#include <charconv>
#include <filesystem>
#include <set>

#include "ground/paths.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/suggest.hpp"
#include "xgm/config/diagnostics.hpp"
#include "xgm/geo/run/surface_files.hpp"
#include "xgm/io/file.hpp"

namespace xgm::geo {
namespace {

constexpr std::uint64_t kMaxBytes = std::uint64_t{1}
                                    << 24;  // what is named by mistake may have no end

namespace fs = std::filesystem;

// What `generated` holds is for people: what a scene was made with.
const std::vector<std::string> kKeys{"images", "masks", "cameras", "dem",      "area",
                                     "band",   "truth", "visible", "generated"};

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file), folder_(fs::path(file).parent_path()) {}

  SurfaceFiles read() {
    const YAML::Node root = parse();
    if (root.IsMap()) {
      for (const auto& entry : root) read_entry(entry.first, entry.second);
      if (!seen_.contains("images")) {
        add(root, "has no images", "list at least two: images: [a.tif, b.tif]");
      }
    } else if (diagnostics_.empty()) {
      add(root, "is no scene", "write keys and values: images: [a.tif, b.tif]");
    }
    if (!diagnostics_.empty()) throw UsageError(to_string(diagnostics_));
    return files_;
  }

 private:
  void add(const YAML::Mark& mark, const std::string& message, const std::string& remedy) {
    diagnostics_.push_back({{file_, mark.line + 1, mark.column + 1}, message, remedy});
  }
  void add(const YAML::Node& node, const std::string& message, const std::string& remedy) {
    add(node.Mark(), message, remedy);
  }

  YAML::Node parse() {
    try {
      return YAML::Load(read_file(file_, kMaxBytes));
    } catch (const YAML::Exception& error) {
      add(error.mark, "is no YAML: " + error.msg, "mend it at this place");
    }
    return {};
  }

  void read_entry(const YAML::Node& name, const YAML::Node& value) {
    const std::string key = name.IsScalar() ? name.Scalar() : "";
    if (!seen_.insert(key).second) {
      add(name, "'" + key + "' is written twice", "remove one");
    } else if (key == "images") {
      read_paths(value, key, files_.images);
    } else if (key == "masks") {
      read_paths(value, key, files_.masks);
    } else if (key == "cameras") {
      read_paths(value, key, files_.cameras);
    } else if (key == "dem") {
      read_dem_files(value);
    } else if (key == "area") {
      read_area(value);
    } else if (key == "band") {
      read_band(value);
    } else if (key == "truth") {
      std::vector<std::string> files;
      read_path(value, key, files);
      if (!files.empty()) files_.truth = files.front();
    } else if (key == "visible") {
      read_paths(value, key, files_.visible);
    } else if (key != "generated") {
      add(name, "there is no key '" + key + "' in a scene of satellite images",
          suggest(key, kKeys, "keys"));
    }
  }

  std::string path(const std::string& text) const { return (folder_ / text).string(); }

  void read_path(const YAML::Node& node, const std::string& key, std::vector<std::string>& files) {
    if (!node.IsScalar())
      return add(node, key + " must be a list of files", "write [a.tif, b.tif]");
    const std::string file = path(node.Scalar());
    if (is_folder(file)) {
      add(node, file + " is a folder", "name a file in it");
    } else if (!is_there(file)) {
      add(node, "there is no file " + file, "paths are relative to the scene's file");
    }
    files.push_back(file);
  }

  void read_paths(const YAML::Node& node, const std::string& key, std::vector<std::string>& files) {
    if (!node.IsSequence()) return read_path(node, key, files);
    for (const YAML::Node& item : node) read_path(item, key, files);
  }

  void read_dem_file(const YAML::Node& node) {
    if (!node.IsScalar()) {
      return add(node, "dem must be a file or a list of files", "write dem: \"dem.tif,egm96\"");
    }
    const std::string file = path(node.Scalar());
    if (!is_there(file) && !is_there(file.substr(0, file.rfind(',')))) {
      add(node, "there is no file " + file, "paths are relative to the scene's file");
    }
    files_.dem.push_back(file);
  }

  void read_dem_files(const YAML::Node& node) {
    if (!node.IsSequence()) return read_dem_file(node);
    for (const YAML::Node& item : node) read_dem_file(item);
  }

  void read_area(const YAML::Node& node) {
    std::string text = node.IsScalar() ? node.Scalar() : "";
    if (node.IsSequence()) {  // [west, south, east, north]
      for (const YAML::Node& item : node) {
        text += (text.empty() ? "" : ",") + (item.IsScalar() ? item.Scalar() : "?");
      }
    }
    if (is_there(path(text)) && !text.empty()) text = path(text);
    try {
      parse_area(text.empty() ? "?" : text);
    } catch (const UsageError& error) {
      add(node, error.message(), "");
    }
    files_.area = text;
  }

  void read_band(const YAML::Node& node) {
    const std::string text = node.IsScalar() ? node.Scalar() : "";
    const auto end = std::from_chars(text.data(), text.data() + text.size(), files_.band);
    if (end.ec == std::errc() && end.ptr == text.data() + text.size() && files_.band >= 1) return;
    add(node, "band must be a whole number from 1 on", "leave it out for the mean of all bands");
  }

  std::string file_;
  fs::path folder_;
  std::set<std::string> seen_;
  SurfaceFiles files_;
  Diagnostics diagnostics_;
};

}  // namespace

SurfaceFiles read_surface_scene(const std::string& file) {
  if (is_folder(file)) {
    throw UsageError(file +
                     ": is a folder; name the file of a scene in it (scene.yaml), or give "
                     "--images");
  }
  if (!is_there(file)) throw UsageError(file + ": there is no such file");
  try {
    return Reader(file).read();
  } catch (const Error& error) {
    throw UsageError(error.message());  // such as an empty file: nothing has been matched yet
  }
}

}  // namespace xgm::geo
