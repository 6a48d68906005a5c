// SPDX-License-Identifier: Apache-2.0
// Scenes of satellite images in YAML, and the areas in them.
#include <cmath>

#include "fuzz/support/pipelines.hpp"
#include "fuzz/support/target.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/run/surface_files.hpp"

namespace xgm::fuzz {
namespace {

void check_area(const std::string& text) {
  geo::WantedArea area;
  if (!accepts(text, [&] { area = geo::parse_area(text); })) return;
  require(!area.box || ((*area.box)[0] < (*area.box)[2] && (*area.box)[1] < (*area.box)[3]),
          "an area in degrees is not empty");
  require(area.window.empty() || (area.window.x >= 0 && area.window.y >= 0),
          "a window begins in the image");
  require(area.box.has_value() + !area.window.empty() == (text.empty() ? 0 : 1),
          "an area is given in one way");
}

/// Every line of the message begins with the file's place.
void check_message(const std::string& message, const std::string& file) {
  for (std::size_t begin = 0; begin < message.size();) {
    require(message.compare(begin, file.size(), file) == 0, "a mistake begins with its place");
    const std::size_t end = message.find('\n', begin);
    begin = end == std::string::npos ? message.size() : end + 1;
  }
}

}  // namespace

void check(std::string_view input) {
  static const testing::TemporaryFolder folder;
  for (const char* name : {"a.tif", "b.tif"}) folder.write(name, "");
  const std::string file = folder.write("scene.yaml", std::string(input));
  try {
    const geo::SurfaceFiles files = geo::read_surface_scene(file);
    require(!files.images.empty() && files.band >= 0, "a scene has images");
    check_area(files.area);
  } catch (const UsageError& error) {
    check_message(error.message(), file);
  }
}

std::vector<std::string> seeds() {
  return {
      "images: [a.tif, b.tif]\nmasks: [a.tif, b.tif]\ncameras: [a.tif, b.tif]\n"
      "dem: [\"a.tif,egm96\", b.tif]\narea: [55.64, -21.24, 55.66, -21.22]\nband: 2\n",
      "images:\n  - a.tif\n  - b.tif\ndem: a.tif\narea: 100,200:64x64\n",
      "generated: {seed: 1}\nimages: a.tif\n"};
}

std::vector<std::string> words() {
  std::vector<std::string> words = yaml_words();
  for (const char* word : {"images: ", "masks: ", "cameras: ", "dem: ", "area: ", "band: ",
                           "generated: ", "a.tif", "b.tif", "1,2:3x4", "1,2,3,4", "..", "/"}) {
    words.emplace_back(word);
  }
  return words;
}

}  // namespace xgm::fuzz
