// SPDX-License-Identifier: Apache-2.0
#include "run_inputs.hpp"

#include <spdlog/spdlog.h>

namespace xgm::cli {
namespace {

std::optional<SceneFiles> plan_scene(const RunOptions& options, const Registry& registry) {
  SceneFiles files;
  if (!options.scene.empty()) {
    try {
      files = find_scene(options.scene, registry, options.scene_name, options.dataset);
    } catch (const Error& error) {
      throw UsageError(error.message());
    }
  } else if (!options.images.left.empty()) {
    files.name = options.images.left;
    files.images = options.images;
  } else if (!options.images.left_mask.empty() || !options.images.right_mask.empty()) {
    throw UsageError("masks need images: give a SCENE_DIR, or --left and --right");
  } else {
    return std::nullopt;
  }
  if (!options.images.left_mask.empty()) files.images.left_mask = options.images.left_mask;
  if (!options.images.right_mask.empty()) files.images.right_mask = options.images.right_mask;
  return files;
}

void plan_disparities(Plan& plan, const RunOptions& options, const Pipeline& pipeline) {
  if (!options.disparities.empty()) {
    plan.disparities = parse_disparities(options.disparities);
    plan.disparities_from = "command line";
  } else if (plan.scene && plan.scene->disparities) {
    plan.disparities = *plan.scene->disparities;
    const std::string& file = plan.scene->calibration_file;
    plan.disparities_from = file.empty() ? "data set " + plan.scene->dataset : file;
  } else if (!plan.scene) {
    plan.disparities_from = "sample pair";  // known once it is generated
  } else if (pipeline.disparities()) {
    plan.disparities = *pipeline.disparities();
    plan.disparities_from = "pipeline";
  } else {
    throw UsageError(
        "nothing says which disparities to search; add --disparities MIN:MAX, or a line "
        "ndisp=NUMBER to the scene's calib.txt, or 'disparities: [MIN, MAX]' to the pipeline");
  }
}

std::string text_of(Interval interval) {
  return std::to_string(interval.begin) + " to " + std::to_string(interval.end - 1);
}

}  // namespace

Plan make_plan(const RunOptions& options, const Pipeline& pipeline, const Registry& registry) {
  Plan plan;
  plan.scene = plan_scene(options, registry);
  if (options.range_maps.empty()) {
    plan_disparities(plan, options, pipeline);
    return plan;
  }
  if (!pipeline.accepts_range_maps()) {
    throw UsageError(
        "--range-maps: this pipeline's matcher needs one range for the whole image; "
        "use --disparities MIN:MAX or another pipeline");
  }
  plan.range_maps = parse_range_maps(options.range_maps);
  plan.disparities_from = "range maps";
  return plan;
}

Scene read_scene(const Plan& plan) {
  if (plan.scene) return load_scene(*plan.scene);
  Scene scene = sample_scene();
  scene.notes.push_back("no images were given: the built-in sample pair is matched (" +
                        std::to_string(scene.pair.size().width) + " x " +
                        std::to_string(scene.pair.size().height) + ")");
  return scene;
}

DisparityRange make_range(const Plan& plan, Scene& scene) {
  const cv::Size size = scene.pair.size();
  if (plan.range_maps) {
    const auto& [min_file, max_file] = *plan.range_maps;
    DisparityRange range = read_range_maps(min_file, max_file);
    if (range.size() != size) {
      throw Error(min_file + ": is " + std::to_string(range.size().width) + " x " +
                  std::to_string(range.size().height) + " pixels but the images are " +
                  std::to_string(size.width) + " x " + std::to_string(size.height) +
                  "; range maps have the size of the left image");
    }
    scene.inputs.push_back({"smallest disparities", min_file, identify_file(min_file)});
    scene.inputs.push_back({"largest disparities", max_file, identify_file(max_file)});
    return range;
  }
  const bool of_sample = !plan.scene && plan.disparities.empty();
  const Interval wanted = of_sample ? scene.disparities.value() : plan.disparities;
  const Interval possible = clip_to_width(wanted, size.width);
  if (possible.empty()) {
    throw Error("disparities " + text_of(wanted) + " cannot be seen in images " +
                std::to_string(size.width) + " px wide; give a smaller range with --disparities");
  }
  if (possible != wanted) {
    scene.notes.push_back("disparities " + text_of(wanted) + " reach beyond images " +
                          std::to_string(size.width) + " px wide: " + text_of(possible) +
                          " are searched");
  } else if (possible.size() >= size.width && size.width > 1) {
    scene.notes.push_back("disparities " + text_of(wanted) + " (" + plan.disparities_from +
                          ") are as many as the image is wide; a narrower range is faster and "
                          "safer: --disparities MIN:MAX");
  }
  return DisparityRange::uniform(size, possible);
}

}  // namespace xgm::cli
