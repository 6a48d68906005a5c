// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/dump.hpp"

#include <fnmatch.h>

#include <filesystem>
#include <limits>

#include "io/npy.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm {
namespace {

void make_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw Error(folder.string() + ": cannot be made: " + failure.message());
}

/// Writes one artifact under a stem; remembers the files.
struct Writer {
  std::string stem;
  std::string stage_path;
  std::vector<DumpedFile>& files;
  const std::function<void(const std::string&)>& announce;

  std::string name(const std::string& ending, int first_disparity = 0) const {
    const std::string file = stem + ending;
    announce(file);
    make_folder(std::filesystem::path(file).parent_path());
    files.push_back({file, stage_path, first_disparity});
    return file;
  }

  void operator()(std::monostate) const {}
  void operator()(const MatchRequest*) const {}  // no stage returns one
  void operator()(const cv::Mat1f* confidence) const { write_pfm(name(".pfm"), *confidence); }
  void operator()(const ImagePair* pair) const {
    write_png(name(".left.png"), picture(pair->base));
    write_png(name(".right.png"), picture(pair->match));
  }
  void operator()(const DisparityRange* range) const {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    cv::Mat1f low(range->size(), kNone), high(range->size(), kNone);
    for (int y = 0; y < low.rows; ++y) {
      for (int x = 0; x < low.cols; ++x) {
        const Interval interval = range->at(y, x);
        if (interval.empty()) continue;
        low(y, x) = static_cast<float>(interval.begin);
        high(y, x) = static_cast<float>(interval.end - 1);
      }
    }
    write_pfm(name(".min.pfm"), low);
    write_pfm(name(".max.pfm"), high);
  }
  void operator()(const CostVolume* volume) const {
    write_npy(name(".npy", volume->shape().hull().begin), *volume);
  }
  void operator()(const AggregatedVolume* volume) const {
    write_npy(name(".npy", volume->shape().hull().begin), *volume);
  }
  void map(const DisparityMap& map, const std::string& view) const {
    write_pfm(name(view + ".disparity.pfm"), map.disparity);
    write_png(name(view + ".status.png"), status_picture(map));
    if (!map.confidence.empty()) write_pfm(name(view + ".confidence.pfm"), map.confidence);
  }
  void operator()(const DisparityMap* result) const { map(*result, ""); }
  void operator()(const MatchResult* result) const {
    map(result->forward, ".forward");
    if (result->reverse) map(*result->reverse, ".reverse");
  }
};

}  // namespace

Dumper::Dumper(std::string folder, std::string pattern,
               std::function<void(const std::string&)> announce)
    : folder_(std::move(folder)), pattern_(std::move(pattern)), announce_(std::move(announce)) {}

bool Dumper::wants(const std::string& stage_path) const {
  return !pattern_.empty() &&
         (pattern_ == stage_path || fnmatch(pattern_.c_str(), stage_path.c_str(), 0) == 0);
}

void Dumper::stage_end(const StagePlace& place, const StageStatistics&, const Artifact& result) {
  if (wants(place.path)) write(place.path, result);
}

void Dumper::write(const std::string& stage_path, const Artifact& result) {
  if (std::holds_alternative<std::monostate>(result)) return;
  const int run = ++runs_[stage_path];
  const std::string stem = (std::filesystem::path(folder_) / stage_path).string() +
                           (run > 1 ? "." + std::to_string(run) : "");
  std::visit(Writer{stem, stage_path, files_, announce_}, result);
}

}  // namespace xgm
