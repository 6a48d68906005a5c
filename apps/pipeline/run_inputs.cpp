// SPDX-License-Identifier: Apache-2.0
#include "run_inputs.hpp"

#include <spdlog/spdlog.h>

#include <filesystem>

#include "values.hpp"
#include "xgm/evaluation/metrics.hpp"
#include "xgm/synthesis/plain_scene.hpp"

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

/// A scene may be listed without them. What cannot go well is not begun.
void require_images(const SceneFiles& scene) {
  const PairFiles& images = scene.images;
  for (const std::string& file : {images.left, images.right, images.left_mask, images.right_mask}) {
    std::error_code unusable;
    if (file.empty() || std::filesystem::is_regular_file(file, unusable)) continue;
    throw UsageError("scene " + scene.name + " cannot be matched: " + file +
                     ": no such file; add it, or give the images with --left and --right");
  }
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
  if (plan.scene) require_images(*plan.scene);
  if (!options.memory_limit.empty()) {
    plan.memory_limit = parse_bytes(options.memory_limit, "--memory-limit");
  }
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

namespace {

Scene read_scene(const Plan& plan) {
  if (plan.scene) return load_scene(*plan.scene);
  Scene scene = synthesis::sample_scene();
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

/// All that can be wrong with the truth is found by judging an empty map.
void require_judgeable(const Scene& scene) {
  evaluate(DisparityMap(scene.pair.size()), scene.truth.disparity, {}, scene.truth.non_occluded);
}

/// Before matching: a mistake in these files should not cost the user a run.
void read_truth_of_options(const RunOptions& options, Scene& scene) {
  scene.truth = {.disparity = read_disparities(options.truth, options.truth_divisor)};
  scene.inputs.push_back({"truth", options.truth, identify_file(options.truth)});
  if (!options.truth_mask.empty()) {
    scene.truth.non_occluded = read_mask(options.truth_mask);
    scene.inputs.push_back({"truth mask", options.truth_mask, identify_file(options.truth_mask)});
  }
  require_judgeable(scene);
}

/// What comes with the scene is a help, no wish of the user: if it is of no use, the run goes on.
void read_truth_of_scene(const SceneFiles& files, Scene& scene) {
  try {
    scene.truth = load_truth(files.truth, scene.pair.size());
    if (scene.truth.disparity.empty()) return;
    require_judgeable(scene);
    for (InputFile& file : identify_truth(files.truth)) scene.inputs.push_back(std::move(file));
  } catch (const Error& error) {
    scene.truth = {};
    spdlog::warn("the scene's truth is not used: {}", error.message());
  }
}

}  // namespace

Inputs read_inputs(const RunOptions& options, const Plan& plan) {
  Scene scene = read_scene(plan);
  DisparityRange range = make_range(plan, scene);
  if (!options.truth.empty()) {
    read_truth_of_options(options, scene);
  } else if (plan.scene) {
    read_truth_of_scene(*plan.scene, scene);
  }
  for (const std::string& note : scene.notes) spdlog::info(note);
  return {std::move(scene), std::move(range)};
}

}  // namespace xgm::cli
