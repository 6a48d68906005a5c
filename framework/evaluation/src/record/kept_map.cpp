// SPDX-License-Identifier: Apache-2.0
#include "record/kept_map.hpp"

#include <limits>

#include "xgm/io/write_maps.hpp"

namespace xgm {
namespace {

/// Pictures are the only part of a map in files that grows with the images: they show fewer pixels
/// where little memory is allowed.
double picture_pixels(std::optional<double> memory_limit) {
  constexpr double kShare = 0.25;
  return memory_limit ? MapInParts::picture_pixels(kShare * *memory_limit)
                      : std::numeric_limits<double>::infinity();
}

/// The images, which are not too large to be held.
void hold(Scene& scene) {
  scene.pair = scene.windows->read({{}, scene.size()});
  scene.windows.reset();
}

void paste(const DisparityMap& part, const cv::Rect& place, DisparityMap& whole) {
  part.disparity.copyTo(whole.disparity(place));
  part.status.copyTo(whole.status(place));
  if (part.confidence.empty()) return;
  if (whole.confidence.empty()) whole.confidence.create(whole.size());
  part.confidence.copyTo(whole.confidence(place));
}

}  // namespace

void KeptMap::add_bytes(SceneInputs& inputs) const {
  const cv::Size size = inputs.scene.size();
  if (!inputs.scene.windows) {
    inputs.besides.after += bytes_to_write_maps(size);
    return;
  }
  const double pixels = picture_pixels(inputs.memory_limit);
  inputs.besides.after += MapInParts::finish_bytes(size, pixels);
  inputs.besides.held += MapInParts::held_bytes(size, pixels) + inputs.scene.windows_bytes;
}

SceneRun KeptMap::match(const Pipeline& pipeline, SceneInputs inputs, const RunOptions& options,
                        const ChooseParts& choose) {
  const MatchParts parts = choose ? choose(inputs, options) : MatchParts();
  const Interval searched = inputs.range.hull();
  MatchScene how;
  if (parts && inputs.scene.windows) {
    files_ = std::make_unique<MapInParts>(folder_, inputs.scene.size(), searched,
                                          picture_pixels(inputs.memory_limit));
    how = [&](const SceneInputs&, const RunOptions& watched) {
      parts([&](const auto& place, const auto& part) { files_->take(place, part); }, watched);
      return MatchResult{};
    };
  } else if (parts) {
    how = [&](const SceneInputs& scene, const RunOptions& watched) {
      MatchResult result{DisparityMap(scene.scene.size()), std::nullopt};
      parts([&](const auto& place, const auto& part) { paste(part, place, result.forward); },
            watched);
      return result;
    };
  } else if (choose) {  // which has seen to the memory
    if (inputs.scene.windows) hold(inputs.scene);
    how = [&](const SceneInputs& scene, const RunOptions& watched) {
      return pipeline.run({scene.scene.pair, scene.range, {}}, watched);
    };
  }
  SceneRun run = match_scene(pipeline, std::move(inputs), options, how);
  if (!files_) {
    summary_ = MapSummary(searched);
    summary_.add(run.maps.forward);
  }
  return run;
}

void KeptMap::write(const DisparityMap& map) {
  if (files_) {
    files_->finish();
  } else {
    write_maps(folder_, map);
  }
}

}  // namespace xgm
