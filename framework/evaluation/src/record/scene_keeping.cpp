// SPDX-License-Identifier: Apache-2.0
#include "record/scene_keeping.hpp"

#include "xgm/base/error.hpp"
#include "xgm/pipeline/question.hpp"

namespace xgm {
namespace {

/// Results of stages that are not run would be missing.
bool shows_stages(const RecordRequest& request) {
  return request.report || !request.dump.empty() || !request.explained.empty();
}

/// Images in memory have no hashes by which they are known again.
bool is_in_files(const SceneRequest& scene) {
  return std::holds_alternative<SceneFiles>(scene.scene);
}

}  // namespace

void check_keeping(const RecordRequest& request, const SceneRequest& scene) {
  const std::string option = request.keep ? request.keep->option() : "";
  if (option.empty()) return;
  if (shows_stages(request)) {
    throw UsageError(option +
                     "stages whose results are kept are not run again; leave it out, or leave out "
                     "--report, --dump and --explain");
  }
  if (!is_in_files(scene)) {
    throw UsageError(option + "needs images in files: give a SCENE_DIR, or --left and --right");
  }
}

Keeping keep_scene(const Pipeline& pipeline, const SceneRequest& scene, const SceneInputs& inputs,
                   const RecordRequest& request, Observer* observer) {
  if (!request.keep || shows_stages(request) || !is_in_files(scene)) return {};
  const Json question = question_of(pipeline, scene, inputs, request.keep->plugin_files);
  return {*request.keep, request.folder, question, question_of_matcher(question), observer};
}

}  // namespace xgm
