// SPDX-License-Identifier: Apache-2.0
// Tiny trees of files in the layouts of data sets, and their scenes.
#pragma once

#include <filesystem>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/pfm.hpp"
#include "xgm/io/scene.hpp"

namespace xgm::testing {

inline constexpr int kTreeHeight = 3, kTreeWidth = 4;

class Tree : public TemporaryFolder {
 public:
  /// A 4 x 3 image, map or text by the ending of the name; folders are made.
  void add(const std::string& name, double value = 9) const {
    const std::string file = make_way(name);
    if (name.ends_with(".pfm")) {
      write_pfm(file, cv::Mat1f(kTreeHeight, kTreeWidth, static_cast<float>(value)));
    } else {
      write_png(file, cv::Mat1b(kTreeHeight, kTreeWidth,
                                cv::saturate_cast<uchar>(value)));  // OpenCV goes by the content
    }
  }
  void add_text(const std::string& name, const std::string& text) const {
    make_way(name);
    write(name, text);
  }
  void add_folder(const std::string& name) const {
    std::filesystem::create_directories(*this / name);
  }
  std::vector<SceneFiles> scenes(const std::string& folder = ".",
                                 const std::string& dataset = {}) const {
    return find_scenes(*this / folder, builtins(), dataset);
  }
  std::string error(const std::string& folder = ".", const std::string& dataset = {}) const {
    return error_of([&] { scenes(folder, dataset); });
  }

 private:
  std::string make_way(const std::string& name) const {
    const std::string file = *this / name;
    std::filesystem::create_directories(std::filesystem::path(file).parent_path());
    return file;
  }
};

/// The names, joined by spaces.
inline std::string names(const std::vector<SceneFiles>& scenes) {
  std::string text;
  for (const SceneFiles& scene : scenes) text += (text.empty() ? "" : " ") + scene.name;
  return text;
}

/// All that is wrong with files of the scene, a line each.
inline std::string faults(const SceneFiles& scene) {
  std::string text;
  for (const FileFault& fault : scene.faults) text += fault.message + '\n';
  return text;
}

/// Whether some sentence of what is missing has this in it.
inline bool lacks(const SceneFiles& scene, const std::string& what) {
  for (const std::string& sentence : scene.missing) {
    if (contains(sentence, what)) return true;
  }
  return false;
}

inline const std::string kCalibTxt =
    "cam0=[1038.018 0 322.037; 0 1038.018 243.393; 0 0 1]\n"
    "cam1=[1038.018 0 375.308; 0 1038.018 243.393; 0 0 1]\n"
    "doffs=53.271\nbaseline=176.252\nwidth=718\nheight=496\nndisp=73\nisint=0\n";

}  // namespace xgm::testing
