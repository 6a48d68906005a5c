// SPDX-License-Identifier: Apache-2.0
#include "xgm/exchange/request.hpp"

#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <utility>

#include "io/npy.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/data/calibration_json.hpp"
#include "xgm/data/interval_mapping.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm::exchange {
namespace {

namespace fs = std::filesystem;

std::string temporary_folder() {
  const char* const named = std::getenv("TMPDIR");
  return named != nullptr && *named != '\0' ? named : "/tmp";
}

/// Of this process and for its user alone; gone with what is in it when this is.
class Folder {
 public:
  Folder() : path_(fs::absolute(fs::path(temporary_folder()) / "xgm-XXXXXX").string()) {
    if (::mkdtemp(path_.data()) == nullptr) {
      throw Error(path_ + ": no folder can be made: " + std::strerror(errno) +
                  "; set TMPDIR to a folder with room");
    }
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const std::string& name) const { return (fs::path(path_) / name).string(); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

cv::Mat flipped(const cv::Mat& matrix) {
  cv::Mat turned;
  cv::flip(matrix, turned, 1);
  return turned;
}

/// Red, green and blue, in the order in which other programs read a file; 0 where there are no
/// data.
cv::Mat levels_of(const Image& image) {
  cv::Mat levels = image.planes.front();
  if (image.planes.size() == 3) {
    cv::merge(std::vector<cv::Mat>{image.planes[2], image.planes[1], image.planes[0]}, levels);
  }
  if (image.valid.empty()) return levels;
  levels = levels.clone();
  levels.setTo(0, image.valid == 0);
  return levels;
}

/// An 8-bit image in the order of PNG files: rounded levels, black where there are no data.
void write_picture(const std::string& file, const Image& image, bool mirrored) {
  const cv::Mat3b colours = picture(image);
  const cv::Mat shown = mirrored ? flipped(colours) : cv::Mat(colours);
  if (image.planes.size() == 3) return write_png(file, cv::Mat3b(shown));
  cv::Mat1b grey;
  cv::extractChannel(shown, grey, 0);
  write_png(file, grey);
}

/// Of the mirrored right image as base: its camera is the mirrored right one.
Calibration mirrored(const Calibration& camera, int width) {
  Calibration turned = camera;
  turned.cx = width - 1 - (camera.cx + camera.doffs);
  return turned;
}

}  // namespace

void declare(ImageFiles& files, ParameterSet& set) {
  set.add_choice("images", files,
                 "png: 8-bit images; npy: grey levels as float32, without rounding.",
                 {{"png", ImageFiles::png}, {"npy", ImageFiles::npy}});
}

struct Request::Parts {
  Folder folder{};
  cv::Size size{};
  bool is_mirrored = false;
  int first = 0;  ///< disparity that is searched, as it is handed over
  Json json{};
  const Context& context;

  cv::Mat turned(const cv::Mat& matrix) const { return is_mirrored ? flipped(matrix) : matrix; }

  /// NAME.npy, or else NAME.pfm; empty if there is neither.
  cv::Mat1f read(const std::string& name) const {
    cv::Mat1f values;
    std::string file = folder / (name + ".npy");
    if (fs::exists(file)) {
      const NpyArray array = read_npy(file);
      require_size(array.shape, name + ".npy");
      values.create(size);
      std::size_t i = 0;
      for (float& value : values) {
        value = static_cast<float>(array.at(i++));
        if (!std::isfinite(value)) value = std::numeric_limits<float>::quiet_NaN();
      }
    } else if (fs::exists(file = folder / (name + ".pfm"))) {
      values = read_pfm(file);
      require_size({static_cast<std::size_t>(values.rows), static_cast<std::size_t>(values.cols)},
                   name + ".pfm");
    }
    return values.empty() ? values : cv::Mat1f(turned(values));
  }

  void require_size(const std::vector<std::size_t>& shape, const std::string& name) const {
    const std::vector<std::size_t> wanted{static_cast<std::size_t>(size.height),
                                          static_cast<std::size_t>(size.width)};
    if (shape == wanted) return;
    throw Error("the program wrote a " + name + " of the shape " + shape_text(shape) + ", and " +
                shape_text(wanted) + " is wanted: height, width");
  }

  Json write_view(const std::string& name, const Image& image, ImageFiles files) const {
    Json view{{"image", name + (files == ImageFiles::png ? ".png" : ".npy")}};
    const std::string file = folder / view.at("image").text();
    if (files == ImageFiles::png) {
      write_picture(file, image, is_mirrored);
    } else {
      write_npy(file, turned(levels_of(image)));
    }
    if (image.valid.empty()) return view;
    const cv::Mat1b usable(image.valid != 0);
    view["mask"] = name + "_mask.png";
    write_png(folder / view.at("mask").text(), cv::Mat1b(turned(usable)));
    return view;
  }
};

Request::Request(std::string kind, const ImagePair& pair, ImageFiles files, const Context& context)
    : parts_(new Parts{.context = context}) {
  parts_->size = pair.size();
  parts_->is_mirrored = pair.is_reverse;
  const StagePlace& place = context.place();
  const RunFacts& facts = context.run();
  Json& json = parts_->json;
  json = {{"xgm_exchange", 1},
          {"kind", std::move(kind)},
          {"scene", facts.scene},
          {"view", pair.is_reverse ? "right" : "left"},
          {"scale", place.level.scale},
          {"width", pair.size().width},
          {"height", pair.size().height},
          {"threads", thread_count()},
          {"base", parts_->write_view("base", pair.base, files)},
          {"match", parts_->write_view("match", pair.match, files)}};
  if (!facts.calibration) return;
  const Calibration camera = reduced(*facts.calibration, place.level.scale);
  json["calibration"] = to_json(pair.is_reverse ? mirrored(camera, pair.size().width) : camera);
}

Request::~Request() = default;

void Request::add(const DisparityRange& range) {
  const bool mirror = parts_->is_mirrored;
  const auto handed = [&](Interval given) { return mirror ? reversed(given) : given; };
  const Interval hull = handed(range.hull());
  parts_->first = hull.begin;
  parts_->json["disparities"] = Json::array();
  parts_->json["disparities"].push_back(hull.begin);
  parts_->json["disparities"].push_back(hull.end - 1);
  if (range.is_uniform()) return;
  cv::Mat1i first(range.size()), last(range.size());
  for (int y = 0; y < first.rows; ++y) {
    for (int x = 0; x < first.cols; ++x) {
      const Interval own = handed(range.at(y, x));  // an empty one ends before it begins
      first(y, x) = own.begin;
      last(y, x) = own.end - 1;
    }
  }
  write_npy(parts_->folder / "first.npy", parts_->turned(first));
  write_npy(parts_->folder / "last.npy", parts_->turned(last));
  parts_->json["range"] = {{"first", "first.npy"}, {"last", "last.npy"}};
}

void Request::add(const DisparityMap& map) {
  const cv::Mat1f disparity =
      parts_->is_mirrored ? cv::Mat1f(-map.disparity) : map.disparity;  // not in place
  write_npy(parts_->folder / "map.npy", parts_->turned(disparity));
  write_npy(parts_->folder / "status.npy", parts_->turned(map.status));
  parts_->json["map"] = {{"disparity", "map.npy"}, {"status", "status.npy"}};
}

void Request::run(const Program& program) {
  const std::string file = parts_->folder / "request.json";
  parts_->json["folder"] = parts_->folder.path();
  write_file(file, parts_->json.dump(2) + "\n");
  run_program(program, file, parts_->context);
}

cv::Mat1f Request::disparities() const {
  cv::Mat1f found = parts_->read("disparity");
  if (found.empty()) {
    throw Error(
        "the program wrote neither disparity.npy nor disparity.pfm into the folder of "
        "its request");
  }
  return parts_->is_mirrored ? cv::Mat1f(-found) : found;
}

cv::Mat1f Request::confidence() const { return parts_->read("confidence"); }

CostVolume Request::costs(const ImagePair& pair, const VolumeShapePtr& shape,
                          const CostScale& scale) const {
  const std::string file = parts_->folder / "cost.npy";
  if (!fs::exists(file)) {
    throw Error("the program wrote no cost.npy into the folder of its request");
  }
  return read_costs({file, parts_->first, parts_->is_mirrored}, pair, shape, scale);
}

}  // namespace xgm::exchange
