// SPDX-License-Identifier: Apache-2.0
// Kind "preprocess": from an image pair to a better one.
#pragma once

#include <memory>
#include <string>

#include "xgm/data/pair_windows.hpp"
#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

/// What a stage has found on a whole scene, for parts of it.
class XGM_API PartPreprocess {
 public:
  virtual ~PartPreprocess();
  /// Rows above and below a part that it looks at.
  virtual int margin() const = 0;
  /// `origin`: where the part lies in the scene.
  virtual ImagePair run(const ImagePair& part, cv::Point origin) const = 0;
  /// What Preprocess::restored() makes the same of in another process, as JSON. Empty, the default:
  /// nothing does, so that each process looks at the whole scene.
  virtual std::string state() const;
};

class XGM_API Preprocess : public Stage {
 public:
  static constexpr std::string_view kKind = "preprocess";
  static constexpr std::string_view kMeaning = "makes a better image pair of an image pair";

  /// The base image keeps its geometry, so that the disparity map stays one of the image given.
  virtual ImagePair run(const ImagePair& pair, const Context& context) const = 0;

  /// For a stage that looks at the whole image before it changes a pixel: what it does to parts of
  /// the scene. Null, the default, if run() does to a part what it does to the whole.
  virtual std::shared_ptr<const PartPreprocess> fitted(const PairWindows& scene,
                                                       const Context& context) const;
  /// What fitted() returned for a scene of this size when its state() was this one: the same to the
  /// last bit. Null, the default, if it is no state of this stage.
  virtual std::shared_ptr<const PartPreprocess> restored(const std::string& state,
                                                         cv::Size scene) const;

  /// What every result is looked at for in a run: sizes, planes, levels and view.
  static std::optional<Fault> fault_of(const ImagePair& result, const ImagePair& pair,
                                       const Context& context);
};

}  // namespace xgm
