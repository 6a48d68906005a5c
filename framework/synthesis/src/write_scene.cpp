// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <filesystem>
#include <opencv2/core.hpp>

#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"
#include "xgm/base/text.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/pfm.hpp"
#include "xgm/synthesis/generate.hpp"

namespace xgm::synthesis {
namespace fs = std::filesystem;
namespace {

constexpr const char* kRecord = "scene.json";

template <class Value>
void write_levels(const std::string& file, const Image& image, double factor) {
  std::vector<cv::Mat_<Value>> planes;
  for (const cv::Mat1f& plane : image.planes) {
    cv::Mat_<Value> rounded;
    plane.convertTo(rounded, rounded.type(), factor);
    planes.push_back(rounded);
  }
  if (planes.size() == 1) return write_png(file, planes.front());
  cv::Mat_<cv::Vec<Value, 3>> colour;
  cv::merge(planes, colour);
  write_png(file, colour);
}

void write_image(const std::string& file, const Image& image, int bits) {
  if (bits == 8)
    write_levels<std::uint8_t>(file, image, 1);
  else
    write_levels<std::uint16_t>(file, image, 257);
}

/// Middlebury's values: 255 where a pixel is seen in both views, 128 where it is hidden in one.
cv::Mat1b benchmark_mask(const cv::Mat1b& non_occluded) {
  cv::Mat1b mask(non_occluded.size(), std::uint8_t{128});
  mask.setTo(255, non_occluded);
  return mask;
}

std::string camera(const Calibration& c, double cx) {
  return "[" + short_number(c.focal) + " 0 " + short_number(cx) + "; 0 " + short_number(c.focal) +
         " " + short_number(c.cy) + "; 0 0 1]\n";
}

std::string calibration_text(const GeneratedScene& scene) {
  const Calibration& c = scene.calibration;
  const cv::Size size = scene.truth.size();
  std::string text = "cam0=" + camera(c, c.cx) + "cam1=" + camera(c, c.cx + c.doffs) +
                     "doffs=" + short_number(c.doffs) + "\nbaseline=" + short_number(c.baseline) +
                     "\nwidth=" + std::to_string(size.width) +
                     "\nheight=" + std::to_string(size.height) + "\n";
  if (scene.disparities.begin >= 0) text += "ndisp=" + std::to_string(scene.disparities.end) + "\n";
  return text + "isint=0\nvmin=" + std::to_string(scene.disparities.begin) +
         "\nvmax=" + std::to_string(scene.disparities.end - 1) + "\n";
}

std::string record_text(const Options& options) {
  Json record;
  record["format"] = 1;
  record["seed"] = options.seed;
  record["size"] = {options.size.width, options.size.height};
  record["disparities"] = {options.disparities.begin, options.disparities.end - 1};
  record["objects"] = options.objects;
  record["content"] = options.content == Content::rich ? "rich" : "plain";
  record["colour"] = options.colour;
  record["bits"] = options.bits;
  record["lens"] = options.lens;
  record["samples"] = options.samples;
  record["sensor_noise"] = options.sensor_noise;
  Faults faults = options.faults;
  for (const FaultKind& kind : fault_kinds())
    for (const FaultValue& value : kind.values)
      record["faults"][kind.name][value.name] = value.in(faults);
  return record.dump(2) + "\n";
}

void write_files(const fs::path& folder, const GeneratedScene& scene, const Options& options) {
  const auto in = [&](const char* name) { return (folder / name).string(); };
  write_image(in("im0.png"), scene.pair.base, options.bits);
  write_image(in("im1.png"), scene.pair.match, options.bits);
  write_pfm(in("disp0GT.pfm"), scene.truth);
  write_pfm(in("disp1GT.pfm"), cv::Mat1f(-scene.reverse_truth));
  write_png(in("mask0nocc.png"), benchmark_mask(scene.non_occluded));
  write_png(in("mask1nocc.png"), benchmark_mask(scene.reverse_non_occluded));
  write_file(in("calib.txt"), calibration_text(scene));
  write_file(in(kRecord), record_text(options));
}

/// Nothing of value may be lost to a mistyped name.
void require_replaceable(const fs::path& folder) {
  if (!fs::exists(folder) || fs::exists(folder / kRecord)) return;
  if (fs::is_directory(folder) && fs::is_empty(folder)) return;
  throw Error(folder.string() + ": is there and is no generated scene (it has no " + kRecord +
              "); remove it, or choose another folder");
}

/// A hidden folder beside `folder`, gone at the end unless it has become something else.
class Workplace {
 public:
  explicit Workplace(const fs::path& folder)
      : path_(folder.parent_path() /
              ("." + folder.filename().string() + "." + std::to_string(::getpid()) + ".part")) {
    fs::create_directories(path_);
  }
  ~Workplace() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

void write_scene(const std::string& folder, const GeneratedScene& scene, const Options& options) {
  // Without the end that "scene/" has, so that there is a name to derive others from.
  fs::path target = fs::absolute(folder).lexically_normal();
  if (target.filename().empty()) target = target.parent_path();
  try {
    require_replaceable(target);
    const Workplace workplace(target);
    write_files(workplace.path(), scene, options);
    fs::remove_all(target);
    fs::rename(workplace.path(), target);
  } catch (const fs::filesystem_error& failure) {
    throw Error(folder + ": cannot be written: " + failure.code().message() +
                "; check the folder, its permissions and the free space");
  }
}

}  // namespace xgm::synthesis
