// SPDX-License-Identifier: Apache-2.0
// A pair of images, or a folder of a data set, with errors told as the command line tells them.
//   match_files PIPELINE LEFT RIGHT MAX_DISPARITY
//   match_files PIPELINE SCENE_FOLDER
#include <cstdlib>
#include <iostream>
#include <xgm/pipeline.hpp>

namespace {

xgm::SceneRequest request_of(int count, char** words, const xgm::Registry& plugins) {
  if (count == 3) return {.scene = xgm::find_scene(words[2], plugins)};
  if (count != 5) throw xgm::UsageError("give a scene, or two images and the largest disparity");
  xgm::SceneFiles files{.name = words[2], .images = {.left = words[2], .right = words[3]}};
  return {.scene = files, .disparities = xgm::Interval{0, std::atoi(words[4]) + 1}};
}

}  // namespace

int main(int count, char** words) {
  try {
    xgm::Registry plugins = xgm::Registry::with_builtins();
    plugins.load_path(xgm::plugins_folder());
    const xgm::SceneRequest request = request_of(count, words, plugins);
    const xgm::Pipeline pipeline =
        xgm::require_pipeline(words[1], plugins, {{"postprocess", "[median]"}});
    const xgm::SceneRun run = xgm::run_scene(pipeline, request, {.threads = 2});
    for (const std::string& note : run.scene.notes) std::cout << note << '\n';
    for (const std::string& warning : run.warnings) std::cout << "warning: " << warning << '\n';
    xgm::write_maps("found", run.maps.forward);
    return run.maps.forward.density() > 0 ? 0 : 1;
  } catch (const xgm::UsageError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const xgm::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
