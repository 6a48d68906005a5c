// SPDX-License-Identifier: Apache-2.0
// A small run of a pipeline: how fast its stages are on this machine, and how far its pyramid
// narrows the search of this scene.
#include <algorithm>
#include <chrono>
#include <cstring>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "xgm/base/aligned_buffer.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/pipeline/plan.hpp"

namespace xgm {
namespace {

// Large enough that volumes leave the caches, small enough for a few tenths of a second.
constexpr double kMaxPixels = 0.4e6;

/// What a level searched.
struct Level {
  double width = 0;
  double limits = 0;    ///< disparities that a pixel could have searched
  double cells = 0;     ///< per pixel
  double searched = 0;  ///< disparities per pixel: cells without those that round them up
};

struct StageSeconds {
  std::string path;
  double seconds;
};

/// Times of stages, and what the volumes of levels are.
class Prober final : public Observer {
 public:
  explicit Prober(const Workload& load) : load_(load) {}

  void stage_end(const std::string& path, const StageStatistics& statistics,
                 const Artifact& result) override {
    stages_.push_back({path, statistics.seconds});
    if (const auto* costs = std::get_if<const CostVolume*>(&result)) note((*costs)->shape());
  }
  /// Of levels that searched less than all, finest first.
  std::vector<Level> narrowed() const {
    std::vector<Level> levels = levels_;
    std::erase_if(levels, [](const Level& level) {
      return level.cells >= Workload::room(static_cast<int>(level.limits));
    });
    std::sort(levels.begin(), levels.end(), [](auto& a, auto& b) { return a.width > b.width; });
    return levels;
  }

  const std::vector<StageSeconds>& stages() const { return stages_; }

 private:
  void note(const VolumeShape& shape) {
    const double scale = std::round(double(load_.size.width) / shape.width());
    const double pixels = double(shape.width()) * shape.height() * load_.used;
    levels_.push_back({double(shape.width()), load_.range.size() / scale,
                       static_cast<double>(shape.cells()) / pixels, searched(shape) / pixels});
  }

  static double searched(const VolumeShape& shape) {
    double sum = 0;
    for (int y = 0; y < shape.height(); ++y) {
      for (int x = 0; x < shape.width(); ++x) sum += shape.count(y, x);
    }
    return sum;
  }

  Workload load_;
  std::vector<Level> levels_;
  std::vector<StageSeconds> stages_;
};

/// The straight line through what the two finest levels searched, both views' mean.
std::optional<Narrowing> fit(const std::vector<Level>& levels) {
  if (levels.empty()) return std::nullopt;
  const auto mean_at = [&](double width) {
    Level mean{.width = width};
    double count = 0;
    for (const Level& level : levels) {
      if (level.width != width) continue;
      mean.limits = level.limits;
      mean.cells += level.cells;
      mean.searched += level.searched;
      ++count;
    }
    mean.cells /= count;
    mean.searched /= count;
    return mean;
  };
  const Level fine = mean_at(levels.front().width);
  Narrowing narrowing;
  const auto next = std::find_if(levels.begin(), levels.end(),
                                 [&](const Level& level) { return level.width < fine.width; });
  if (next != levels.end()) {
    const Level coarse = mean_at(next->width);
    narrowing.lost =
        std::clamp((fine.searched - coarse.searched) / (fine.limits - coarse.limits), 0.0, 1.0);
  }
  narrowing.spread = std::max(0.0, fine.cells - narrowing.lost * fine.limits);
  return narrowing;
}

/// Seconds of each call of a stage without those of the stages inside it.
std::map<std::string, double> own_seconds(const std::vector<StageSeconds>& stages) {
  std::map<std::string, double> own;
  for (const StageSeconds& stage : stages) {
    own[stage.path] += stage.seconds;
    std::string around = stage.path;
    while (around.find('.') != std::string::npos) {
      around.resize(around.rfind('.'));
      const auto found = own.find(around);
      if (found == own.end()) continue;
      found->second -= stage.seconds;
      break;
    }
  }
  return own;
}

std::map<std::string, double> speeds(const RunPlan& plan, const std::vector<StageSeconds>& stages) {
  const auto own = own_seconds(stages);
  std::map<std::string, double> updates, seconds, speeds;
  for (const PlannedStage& stage : plan.stages) {
    const auto found = own.find(stage.path);
    if (found == own.end()) continue;
    const std::string key = stage.kind + "/" + stage.plugin;
    updates[key] += stage.needs.updates;
    seconds[key] += found->second;
  }
  for (const auto& [key, time] : seconds) speeds[key] = updates[key] / std::max(time, 1e-9);
  return speeds;
}

/// Bytes per second that all threads together copy, read ones and written ones.
double measure_bandwidth(int threads) {
  constexpr std::size_t kBytes = std::size_t{16} << 20, kPieces = 64, kPiece = kBytes / kPieces;
  const ThreadLimit limit(threads);
  const AlignedBuffer from = new_buffer(kBytes), to = new_buffer(kBytes);
  std::memset(from.get(), 1, kBytes);
  std::memset(to.get(), 1, kBytes);
  double best = 0;
  for (int round = 0; round < 3; ++round) {
    const auto start = std::chrono::steady_clock::now();
    parallel_for(0, static_cast<int>(kPieces), [&](int i) {
      const std::size_t offset = static_cast<std::size_t>(i) * kPiece;
      std::memcpy(static_cast<char*>(to.get()) + offset,
                  static_cast<const char*>(from.get()) + offset, kPiece);
    });
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    best = std::max(best, 2.0 * kBytes / time.count());
  }
  return best;
}

Image reduced(const Image& image, cv::Size size) {
  Image small;
  for (const cv::Mat1f& plane : image.planes) {
    cv::resize(plane, small.planes.emplace_back(), size, 0, 0, cv::INTER_AREA);
  }
  if (!image.valid.empty()) cv::resize(image.valid, small.valid, size, 0, 0, cv::INTER_NEAREST);
  return small;
}

/// The whole question, so many times smaller, for which all pixels have one range.
MatchRequest reduced(const MatchRequest& request, int factor) {
  const cv::Size full = request.pair.size();
  const cv::Size size(std::max(1, full.width / factor), std::max(1, full.height / factor));
  const Interval hull = request.range.hull();
  const Interval range{static_cast<int>(std::floor(double(hull.begin) / factor)),
                       static_cast<int>(std::ceil(double(hull.end - 1) / factor)) + 1};
  return {{reduced(request.pair.base, size), reduced(request.pair.match, size),
           request.pair.is_reverse},
          DisparityRange::uniform(size, range),
          std::nullopt};
}

Experience measure(const Pipeline& pipeline, const MatchRequest& small, int threads) {
  PlanRequest request{.load = workload_of(small, threads)};
  const BufferReuse reuse;  // so that the second run waits for no memory, as little as a large one
  Prober warming(request.load), prober(request.load);
  pipeline.run(small, {.observer = &warming, .threads = threads});
  pipeline.run(small, {.observer = &prober, .threads = threads});
  request.experience.narrowing = fit(prober.narrowed());
  return {request.experience.narrowing, speeds(plan_run(pipeline, request), prober.stages()),
          measure_bandwidth(threads)};
}

}  // namespace

Experience probe(const Pipeline& pipeline, const MatchRequest& request, int threads) {
  const double pixels = request.pair.size().area();
  int factor = 2;
  while (pixels / (factor * factor) > kMaxPixels) factor *= 2;
  return measure(pipeline, reduced(request, factor), threads);
}

Experience probe_whole(const Pipeline& pipeline, const MatchRequest& request, int threads) {
  return measure(pipeline, request, threads);
}

}  // namespace xgm
