// SPDX-License-Identifier: Apache-2.0
#include "options/scene_options.hpp"

#include <algorithm>
#include <opencv2/core/utility.hpp>

#include "xgm/base/parallel.hpp"

namespace xgm::cli {
namespace {

Option add_scene(Command command, SceneOptions& options) {
  return command
      .option("scene", options.scene,
              "Folder of a scene, or of scenes, of any known data set (see 'pipeline list "
              "dataset'). With neither scene nor images the built-in sample pair is matched")
      .type_name("SCENE_DIR");
}

}  // namespace

void add_pipeline(Command command, SceneOptions& options) {
  command
      .option("pipeline", options.pipeline,
              "Pipeline file, or name of a shipped one (with or without .yaml)")
      .type_name("PIPELINE")
      .required();
}

void add_scene_choice(Command command, SceneOptions& options, Option scene) {
  command.option("--scene", options.scene_name, "Which scene, if SCENE_DIR holds several")
      .type_name("NAME")
      .needs(scene);
  add_dataset_option(command, options.dataset).needs(scene);
}

Option add_images(Command command, SceneOptions& options) {
  auto left = command.option("--left", options.images.left, "Left (base) image");
  auto right = command.option("--right", options.images.right, "Right (match) image");
  auto left_mask = command.option("--left-mask", options.images.left_mask,
                                  "Image that is not zero where the left one may be used");
  auto right_mask =
      command.option("--right-mask", options.images.right_mask, "The same for the right one");
  for (Option option : {left, right, left_mask, right_mask}) {
    option.type_name("FILE").existing_file();
  }
  add_no_data_option(command, "--nodata", options.no_data, "images and range maps");
  left.needs(right);
  right.needs(left);
  return left;
}

Option add_interval(Command command, SceneOptions& options) {
  return command
      .option("--disparities", options.disparities,
              "Smallest and largest disparity to search, both included, px: 0:63, -64:64. "
              "Without it: what the data set says (ndisp of calib.txt), else "
              "'disparities' of the pipeline")
      .type_name("MIN:MAX");
}

Option add_search(Command command, SceneOptions& options) {
  auto interval = add_interval(command, options);
  return command
      .option("--range-maps", options.range_maps,
              "Smallest and largest disparity of every pixel, both included: two PFM or "
              "float TIFF files; not finite = nothing to search")
      .type_name("MIN.pfm,MAX.pfm")
      .excludes(interval);
}

Option add_no_data_option(Command command, const std::string& name, std::string& values,
                          const std::string& files) {
  return command
      .option(name, values,
              "Values of " + files +
                  " that mean no data, beside those that a file names itself (GDAL_NODATA): -9999")
      .type_name("VALUE[,VALUE]");
}

void add_matching(Command command, SceneOptions& options) {
  add_set_option(command, options.assignments);
  add_threads_option(command, options.threads);
}

void add_truth(Command command, SceneOptions& options) {
  auto truth = command
                   .option("--truth", options.truth,
                           "True disparities to compare with: PFM, or 8- or 16-bit PNG with "
                           "--truth-divisor (0 = none). Without it those of the scene, if it "
                           "has any")
                   .type_name("FILE")
                   .existing_file();
  command
      .option("--truth-divisor,--truth-scale", options.truth_divisor,
              "What the truth's values are divided by to give px (KITTI: 256)")
      .type_name("NUMBER")
      .needs(truth);
  add_no_data_option(command, "--truth-nodata", options.truth_no_data, "the truth").needs(truth);
  command
      .option("--truth-mask", options.truth_mask,
              "Image that is 255 where the map is judged (Middlebury: mask0nocc.png)")
      .type_name("FILE")
      .existing_file()
      .needs(truth);
}

void add_surroundings(Command command, SceneOptions& options) {
  add_plugin_options(command, options.plugins);
  add_log_level_option(command, options.log_level);
}

void add_log_level_option(Command command, std::string& level) {
  command
      .option("--log-level", level, "debug, info, warning or error; progress is shown down to info")
      .type_name("L")
      .one_of({"debug", "info", "warning", "error"})
      .show_default();
}

void add_scene_or_images(Command command, SceneOptions& options) {
  auto scene = add_scene(command, options);
  add_scene_choice(command, options, scene);
  add_images(command, options).excludes(scene);
}

Option add_dataset_option(Command command, std::string& dataset) {
  return command
      .option("--dataset", dataset,
              "How the folder is laid out, if that is not recognised: name of a data set, YAML "
              "of one, or a file of such YAML")
      .type_name("NAME|YAML|FILE");
}

void add_memory_limit_option(Command command, std::string& limit) {
  command
      .option("--memory-limit", limit,
              "Refuse to begin what is going to take more memory than this ('pipeline plan' "
              "tells how much it is)")
      .type_name("SIZE");
}

void add_threads_option(Command command, int& threads, const std::string& text) {
  constexpr int kMaxThreads = 1024;
  command.option("--threads", threads, text).type_name("N").range(1, kMaxThreads);
}

int use_threads(int threads) {
  if (threads == 0) return thread_count();
  // OpenCV's scheduler complains of more threads than there are processors.
  cv::setNumThreads(std::min(threads, cv::getNumberOfCPUs()));
  return threads;
}

}  // namespace xgm::cli
