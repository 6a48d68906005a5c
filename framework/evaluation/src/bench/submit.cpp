// SPDX-License-Identifier: Apache-2.0
// The folders that benchmarks want uploaded, after their own instructions:
// - Middlebury V3, vision.middlebury.edu/stereo/submit3/upload-format.html
// - ETH3D two-view, eth3d.net/documentation, "Result submission"
// - KITTI 2015, readme.txt of its development kit, "Submission instructions"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string_view>

#include "bench/judge.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/shell.hpp"
#include "xgm/base/text.hpp"
#include "xgm/evaluation/bench_submission.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kDigits = "0123456789";

/// What a benchmark gets of one scene.
struct Upload {
  fs::path folder;  // the benchmark's root
  std::string method;
  const BenchScene& scene;
  DisparityMap map;
  bool sparse = false;  // some map of the method has pixels without disparity
  double seconds = 0;
};

/// "trainingQ" of "MiddEval3/trainingQ" and of "my_trainingQ".
std::string middlebury_half(const BenchScene& scene) {
  std::string_view name = scene.set;
  const std::size_t dash =
      name.find_last_not_of(kDigits);  // of "trainingQ-2", the second of a name
  const bool is_numbered = dash != std::string_view::npos && dash + 1 < name.size();
  if (is_numbered && name[dash] == '-') name = name.substr(0, dash);
  for (const char* half : {"trainingF", "trainingH", "trainingQ", "testF", "testH", "testQ"}) {
    if (name.ends_with(half)) return half;
  }
  throw Error("--submit middlebury: the name of the folder '" + scene.set +
              "' does not end in trainingF, trainingH, trainingQ, testF, testH or testQ, which "
              "uploads are sorted by; call it as the benchmark does");
}

void write_middlebury(const Upload& upload) {
  const fs::path folder = upload.folder / middlebury_half(upload.scene) / upload.scene.files.name;
  fs::create_directories(folder);
  const std::string ending = upload.sparse ? "_s.pfm" : ".pfm";
  write_pfm((folder / ("disp0" + upload.method + ending)).string(), upload.map.disparity);
  write_file((folder / ("time" + upload.method + ".txt")).string(),
             fixed_number(upload.seconds, 3) + "\n");
}

void write_eth3d(const Upload& upload) {
  const fs::path folder = upload.folder / "low_res_two_view";
  fs::create_directories(folder);
  const std::string name = upload.scene.files.name;
  write_pfm((folder / (name + ".pfm")).string(), upload.map.disparity);
  write_file((folder / (name + ".txt")).string(),
             "runtime " + fixed_number(upload.seconds, 3) + "\n");
}

/// "000046_10", by which KITTI calls its frames.
std::string kitti_frame(const BenchScene& scene) {
  const auto is_frame = [](const std::string& name) {
    return name.size() == 9 && name.ends_with("_10") && name.find_first_not_of(kDigits) == 6;
  };
  for (const std::string& name :
       {scene.files.name, fs::path(scene.files.images.left).stem().string()}) {
    if (is_frame(name)) return name;
  }
  throw Error("--submit kitti: the scene '" + scene.files.name +
              "' is not called as KITTI's frames are (000000_10)");
}

/// 16 bit, 256 times the disparity, 0 where there is none.
cv::Mat1w kitti_image(const cv::Mat1f& map) {
  constexpr double kUnits = 256;
  cv::Mat1w image(map.size(), 0);
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      if (!std::isfinite(map(y, x))) continue;
      const double value = std::round(kUnits * static_cast<double>(map(y, x)));
      image(y, x) = static_cast<std::uint16_t>(std::clamp(value, 1.0, 65535.0));
    }
  }
  return image;
}

void write_kitti(const Upload& upload) {
  const fs::path folder = upload.folder / "disp_0";
  fs::create_directories(folder);
  write_png((folder / (kitti_frame(upload.scene) + ".png")).string(),
            kitti_image(upload.map.disparity));
}

struct Benchmark {
  void (*check)(const BenchScene&);
  void (*write)(const Upload&);
};

const Benchmark& benchmark_called(const std::string& name) {
  static const std::map<std::string, Benchmark> benchmarks{
      {"middlebury", {[](const BenchScene& scene) { middlebury_half(scene); }, write_middlebury}},
      {"eth3d", {[](const BenchScene&) {}, write_eth3d}},
      {"kitti", {[](const BenchScene& scene) { kitti_frame(scene); }, write_kitti}}};
  const auto found = benchmarks.find(name);
  if (found == benchmarks.end()) {
    throw Error("--submit " + name + ": choose middlebury, eth3d or kitti");
  }
  return found->second;
}

/// Whether some map of the pipeline has pixels without disparity.
bool is_sparse(const BenchResult& result, std::size_t pipeline) {
  for (std::size_t scene = 0; scene < result.request.scenes.size(); ++scene) {
    if (result.at(pipeline, scene).density < 1) return true;
  }
  return false;
}

bool is_complete(const BenchResult& result, std::size_t pipeline) {
  for (std::size_t scene = 0; scene < result.request.scenes.size(); ++scene) {
    if (result.at(pipeline, scene).state != CellState::done) return false;
  }
  return true;
}

}  // namespace

void check_submission(const BenchRequest& request, const std::string& benchmark,
                      const std::string& method) {
  const Benchmark& to = benchmark_called(benchmark);
  for (const BenchScene& scene : request.scenes) to.check(scene);
  if (!method.empty() && request.pipelines.size() > 1) {
    throw Error("--method " + method + ": names one pipeline, but there are " +
                std::to_string(request.pipelines.size()) + "; submit one at a time");
  }
  constexpr const char* kAllowed =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._+=-";
  if (method.find_first_not_of(kAllowed) != std::string::npos) {
    throw Error("--method " + method +
                ": becomes part of file names; letters, digits and ._+=- "
                "only");
  }
}

std::vector<std::string> write_submission(const BenchResult& result, const std::string& benchmark,
                                          const std::string& method) {
  check_submission(result.request, benchmark, method);
  std::vector<std::string> commands;
  for (std::size_t i = 0; i < result.request.pipelines.size(); ++i) {
    if (!is_complete(result, i)) continue;
    const std::string& name = result.request.pipelines[i].name;
    const fs::path folder = fs::path(result.request.output) / "submit" / name;
    fs::remove_all(folder);  // files of another method would be taken for its results
    for (std::size_t scene = 0; scene < result.request.scenes.size(); ++scene) {
      benchmark_called(benchmark).write({.folder = folder,
                                         .method = method.empty() ? name : method,
                                         .scene = result.request.scenes[scene],
                                         .map = read_result(cell_folder(result.request, i, scene)),
                                         .sparse = is_sparse(result, i),
                                         .seconds = result.at(i, scene).seconds});
    }
    commands.push_back("cd " + shell_word(folder.string()) + " && zip -r " +
                       shell_word("../" + name + ".zip") + " *");
  }
  return commands;
}

}  // namespace xgm
