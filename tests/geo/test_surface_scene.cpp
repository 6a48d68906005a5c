// SPDX-License-Identifier: Apache-2.0
// Scenes of satellite images in YAML.
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/run/surface_files.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using xgm::testing::TemporaryFolder;

TEST_CASE("a scene that is empty, or no file, is a mistake of the user like any other") {
  const TemporaryFolder folder;
  write_file(folder / "scene.yaml", "");
  CHECK_THROWS_WITH_AS(geo::read_surface_scene(folder / "scene.yaml"),
                       doctest::Contains("scene.yaml: is empty"), UsageError);
  CHECK_THROWS_WITH_AS(geo::read_surface_scene(folder / "other.yaml"),
                       doctest::Contains("there is no such file"), UsageError);
}

TEST_CASE("texts too long for the name of a file are names of none") {
  const TemporaryFolder folder;
  const std::string longer(5000, 'a');
  CHECK_THROWS_AS(geo::parse_area(longer), UsageError);
  write_file(folder / "scene.yaml",
             "images: [" + longer + "]\ndem: " + longer + "\narea: " + longer);
  CHECK_THROWS_WITH_AS(geo::read_surface_scene(folder / "scene.yaml"),
                       doctest::Contains("scene.yaml:3:7"), UsageError);
}
