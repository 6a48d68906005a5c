// SPDX-License-Identifier: Apache-2.0
#include "xgm/pipeline/scene_inputs.hpp"

#include "base/stopwatch.hpp"
#include "io/warnings.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace {

/// What is to be searched, as far as it is known before the images are.
struct Search {
  Interval interval{};  ///< unless there are range maps
  std::string from;     ///< for people
};

std::vector<NamedFile> files_of(const RangeMapFiles& maps) {
  return {{"smallest disparities", maps.min}, {"largest disparities", maps.max}};
}

template <class File>
void add_to(std::vector<File>& files, const std::vector<File>& more) {
  files.insert(files.end(), more.begin(), more.end());
}

void require_file(const std::string& file, const std::string& what, const std::string& remedy) {
  const std::string why = file.empty() ? "" : why_unreadable(file);
  if (!why.empty()) throw UsageError(what + file + ": " + why + "; " + remedy);
}

/// A scene may be listed without them. What cannot go well is not begun.
void require_images(const SceneFiles& scene) {
  const PairFiles& images = scene.images;
  const std::string what = "scene " + scene.name + " cannot be matched: ";
  if (images.left.empty() || images.right.empty()) {
    if (!scene.faults.empty()) throw UsageError(what + scene.faults.front().message);
    throw UsageError(what + "it has no " + (images.left.empty() ? "left" : "right") +
                     " image; give both");
  }
  for (const std::string& file : {images.left, images.right, images.left_mask, images.right_mask}) {
    require_file(file, what, "add it, or give the images with --left and --right");
  }
}

void require_truth_files(const TruthFiles& files) {
  for (const std::string& file : {files.disparity.file, files.reverse.file, files.visible.file,
                                  files.non_occluded, files.objects}) {
    require_file(file, "the truth: ", "check the path");
  }
}

void require_truth_size(const GroundTruth& truth, cv::Size size) {
  for (const cv::Mat& map : {cv::Mat(truth.disparity), cv::Mat(truth.reverse),
                             cv::Mat(truth.non_occluded), cv::Mat(truth.objects)}) {
    if (map.empty() || map.size() == size) continue;
    throw UsageError("the truth is not of the images' size; give that of the same scene");
  }
}

void require_range_maps(const SceneRequest& request, const Pipeline& pipeline) {
  if (!request.range_maps && !request.ranges) return;
  if (!pipeline.accepts_range_maps()) {
    throw UsageError(
        "range maps: this pipeline's matcher needs one range for the whole image; "
        "give one range of disparities, or another pipeline");
  }
  if (request.range_maps && request.ranges) {
    throw UsageError("range maps are given as files and in memory; give them in one way");
  }
  if (!request.range_maps) return;
  for (const std::string& file : {request.range_maps->min, request.range_maps->max}) {
    require_file(file, "--range-maps: ", "check the path");
  }
}

/// What the scene itself says is to be searched.
std::optional<Search> search_of(const SceneFiles& scene) {
  if (!scene.disparities) return std::nullopt;
  const std::string& file = scene.disparities_file;
  return Search{*scene.disparities, file.empty() ? "data set " + scene.dataset : file};
}

std::optional<Search> search_of(const Scene& scene) {
  if (!scene.disparities) return std::nullopt;
  return Search{*scene.disparities, scene.name};
}

Search search_of(const SceneRequest& request, const Pipeline& pipeline) {
  if (request.range_maps || request.ranges) return {{}, "range maps"};
  if (request.disparities) return {*request.disparities, request.disparities_from};
  const auto of_scene =
      std::visit([](const auto& scene) { return search_of(scene); }, request.scene);
  if (of_scene) return *of_scene;
  if (pipeline.disparities()) return {*pipeline.disparities(), "pipeline"};
  if (const auto* files = std::get_if<SceneFiles>(&request.scene)) {
    const std::string fault = fault_of(*files, files->calibration_file);
    if (!fault.empty()) {
      throw UsageError(fault + "; or say which disparities to search: --disparities MIN:MAX");
    }
  }
  throw UsageError(
      "nothing says which disparities to search; add --disparities MIN:MAX, or a line "
      "ndisp=NUMBER to the scene's calib.txt, or 'disparities: [MIN, MAX]' to the pipeline");
}

std::string text_of(Interval interval) {
  return std::to_string(interval.begin) + " to " + std::to_string(interval.end - 1);
}

DisparityRange require_size(DisparityRange range, const std::string& name, cv::Size size) {
  if (range.size() == size) return range;
  throw Error(name + ": is " + std::to_string(range.size().width) + " x " +
              std::to_string(range.size().height) + " pixels but the images are " +
              std::to_string(size.width) + " x " + std::to_string(size.height) +
              "; range maps have the size of the left image");
}

DisparityRange read_range(const RangeMapFiles& files, Scene& scene) {
  DisparityRange range =
      require_size(take(read_range_maps(files.min, files.max, files.no_data), scene.warnings),
                   files.min, scene.size());
  add_to(scene.inputs, identify_files(files_of(files)));
  return range;
}

DisparityRange make_range(const SceneRequest& request, const Search& search, Scene& scene) {
  if (request.range_maps) return read_range(*request.range_maps, scene);
  if (request.ranges) return require_size(*request.ranges, "range maps", scene.size());
  const cv::Size size = scene.size();
  const Interval wanted = search.interval;
  const Interval possible = clip_to_width(wanted, size.width);
  if (possible.empty()) {
    throw Error("disparities " + text_of(wanted) + " cannot be seen in images " +
                std::to_string(size.width) + " px wide; give a smaller range with --disparities");
  }
  if (possible != wanted) {
    // What a scene says may be of its full size; who asks for it has mistaken something.
    (request.disparities ? scene.warnings : scene.notes)
        .push_back("disparities " + text_of(wanted) + " reach beyond images " +
                   std::to_string(size.width) + " px wide: " + text_of(possible) + " are searched");
  } else if (possible.size() >= size.width && size.width > 1) {
    scene.notes.push_back("disparities " + text_of(wanted) + " (" + search.from +
                          ") are as many as the image is wide; a narrower range is faster and "
                          "safer: --disparities MIN:MAX");
  }
  return DisparityRange::uniform(size, possible);
}

void read_truth(const TruthFiles& files, SceneInputs& inputs) {
  Scene& scene = inputs.scene;
  GroundTruth truth = load_truth(files, scene.size());
  if (truth.disparity.empty()) return;
  append(inputs.warnings, truth.warnings);  // also of a truth that turns out to be of no use
  require_judgeable(truth);
  scene.truth = std::move(truth);
  add_to(scene.inputs, identify_files(files_of(files)));
}

/// What the calibration says holds for one size of images. Cameras that cannot be used are warned
/// of; a range that is searched must be right.
void check_calibration(const SceneFiles& files, const SceneRequest& request, Scene& scene,
                       std::vector<std::string>& warnings) {
  const std::string unused = "the calibration is not used: ";
  const std::string fault = fault_of(files, files.calibration_file);
  if (!fault.empty()) warnings.push_back(unused + fault);
  const cv::Size size = scene.size();
  const bool is_scenes_own = !request.range_maps && !request.ranges && !request.disparities;
  if (is_scenes_own) require_disparities_of_size(files, size);
  try {
    require_calibrated_size(files, size);
  } catch (const Error& error) {
    scene.calibration.reset();
    warnings.push_back(unused + error.message());
  }
}

/// Also two files may hold one image.
void check_images(const Scene& scene, std::vector<std::string>& warnings) {
  const bool same = scene.windows ? have_same_pixels(*scene.windows)
                                  : have_same_pixels(scene.pair.base, scene.pair.match);
  if (!same) return;
  warnings.push_back(
      "the left and the right image are the same: every disparity is 0; give both views");
}

/// What comes with the scene is a help, no wish of the user: if it is of no use, the run goes on.
void read_truth_of_scene(const SceneFiles& files, SceneInputs& inputs) {
  try {
    read_truth(files.truth, inputs);
  } catch (const Error& error) {
    inputs.warnings.push_back("the scene's truth is not used: " + error.message());
  }
}

/// Maps are compared with a truth as a whole.
void leave_truth(const SceneRequest& request, const SceneFiles& files,
                 std::vector<std::string>& warnings) {
  const TruthFiles& truth = request.truth ? *request.truth : files.truth;
  if (files_of(truth).empty()) return;
  warnings.push_back(
      "the truth is not compared, as the images do not fit into memory as a whole; compare the map "
      "with pipeline eval");
}

Scene scene_of(const SceneRequest& request) {
  const auto* files = std::get_if<SceneFiles>(&request.scene);
  if (files == nullptr) return std::get<Scene>(request.scene);
  return request.scratch.empty() ? load_scene(*files) : open_scene(*files, request.scratch);
}

}  // namespace

std::vector<NamedFile> files_of(const SceneRequest& request) {
  std::vector<NamedFile> files;
  if (const auto* scene = std::get_if<SceneFiles>(&request.scene)) {
    files = files_of(*scene);
    add_to(files, files_of(scene->truth));
  } else {
    for (const InputFile& input : std::get<Scene>(request.scene).inputs) {
      files.push_back({input.role, input.file});
    }
  }
  if (request.truth) add_to(files, files_of(*request.truth));
  if (request.range_maps) add_to(files, files_of(*request.range_maps));
  return files;
}

void check_scene(const SceneRequest& request, const Pipeline& pipeline) {
  if (const auto* files = std::get_if<SceneFiles>(&request.scene)) {
    require_images(*files);
  } else {
    const Scene& scene = std::get<Scene>(request.scene);
    require_sound(scene.pair);
    require_truth_size(scene.truth, scene.pair.size());
  }
  if (request.truth) require_truth_files(*request.truth);
  require_range_maps(request, pipeline);
  search_of(request, pipeline);
}

SceneInputs read_scene(const SceneRequest& request, const Pipeline& pipeline) {
  check_scene(request, pipeline);
  const Stopwatch reading;
  const Search search = search_of(request, pipeline);
  const auto* files = std::get_if<SceneFiles>(&request.scene);
  Scene scene = scene_of(request);
  std::vector<std::string> warnings;
  check_images(scene, warnings);
  if (files != nullptr) check_calibration(*files, request, scene, warnings);
  DisparityRange range = make_range(request, search, scene);
  warnings.insert(warnings.begin(), scene.warnings.begin(), scene.warnings.end());
  SceneInputs inputs{std::move(scene), std::move(range), search.from, request.memory_limit,
                     std::move(warnings)};
  if (inputs.scene.windows) {
    leave_truth(request, *files, inputs.warnings);
  } else if (request.truth) {
    read_truth(*request.truth, inputs);
  } else if (files != nullptr) {
    read_truth_of_scene(*files, inputs);
  }
  inputs.reading_seconds = reading.seconds();
  return inputs;
}

}  // namespace xgm
