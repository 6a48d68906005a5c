// SPDX-License-Identifier: Apache-2.0
// A small run of a pipeline: what its stages do, how fast they are on this machine, and how far its
// pyramid narrows the search of this scene.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "pipeline/trace.hpp"
#include "xgm/base/aligned_buffer.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/data/interval_mapping.hpp"

namespace xgm {
namespace {

// Large enough that volumes leave the caches, small enough for a few tenths of a second.
constexpr double kMaxPixels = 0.4e6;

using Calls = std::vector<trace::Call>;

/// Whether it tells how far a pyramid narrows the search. Beside pyramids, others of a fusion may
/// search everything.
bool matches_level(const trace::Call& call) {
  return call.is_matcher && call.has_volumes && !call.place.level.name.empty();
}

/// The mean of what the matchers of one scale searched, of both views.
trace::Call mean_at(const Calls& calls, double scale) {
  trace::Call mean;
  double count = 0;
  for (const trace::Call& call : calls) {
    if (!matches_level(call) || call.place.level.scale != scale) continue;
    mean.range = call.range;
    mean.cells_per_pixel += call.cells_per_pixel;
    mean.searched += call.searched;
    ++count;
  }
  mean.cells_per_pixel /= count;
  mean.searched /= count;
  return mean;
}

/// The straight line through what the two finest levels searched of their limits, which are the
/// whole range at that scale. The coarsest level searches all of it and tells nothing.
std::optional<Narrowing> fit(const Calls& calls, Interval range) {
  std::vector<double> scales;
  for (const trace::Call& call : calls) {
    if (matches_level(call)) scales.push_back(call.place.level.scale);
  }
  std::sort(scales.begin(), scales.end());
  scales.erase(std::unique(scales.begin(), scales.end()), scales.end());
  if (scales.size() < 2) return std::nullopt;
  scales.pop_back();
  const auto limits = [&](double scale) { return range.size() / scale; };
  const trace::Call fine = mean_at(calls, scales[0]);
  Narrowing narrowing;
  if (scales.size() > 1) {
    const double more = fine.searched - mean_at(calls, scales[1]).searched;
    narrowing.lost = std::clamp(more / (limits(scales[0]) - limits(scales[1])), 0.0, 1.0);
  }
  narrowing.spread = std::max(0.0, fine.cells_per_pixel - narrowing.lost * limits(scales[0]));
  return narrowing;
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

/// The whole question, several times smaller, for which all pixels have one range.
MatchRequest reduced(const MatchRequest& request) {
  const cv::Size full = request.pair.size();
  int factor = 2;
  while (double(full.area()) / (factor * factor) > kMaxPixels) factor *= 2;
  const cv::Size size(std::max(1, full.width / factor), std::max(1, full.height / factor));
  const Interval range = divided(request.range.hull(), factor);
  return {{reduced(request.pair.base, size), reduced(request.pair.match, size),
           request.pair.is_reverse},
          DisparityRange::uniform(size, range),
          std::nullopt};
}

}  // namespace

std::shared_ptr<RunTrace::Calls> RunTrace::watch(const Pipeline& pipeline,
                                                 const MatchRequest& request, RunOptions options) {
  const auto calls = std::make_shared<Calls>();
  calls->pipeline = pipeline;
  calls->load = workload_of(request, options.threads > 0 ? options.threads : thread_count());
  trace::Tracer tracer(calls->load);
  options.observer = &tracer;
  options.kept = nullptr;  // which are of another size
  options.facts.rehearsal = true;
  pipeline.run(request, options);
  calls->calls = tracer.take_calls();
  calls->buffers = tracer.take_buffers();
  calls->events = tracer.take_events();
  return calls;
}

RunTrace::RunTrace(std::shared_ptr<const Calls> calls)
    : narrowing(fit(calls->calls, calls->load.range)), calls_(std::move(calls)) {}

RunTrace RunTrace::of_whole(const Pipeline& pipeline, const MatchRequest& request,
                            const RunOptions& options) {
  const BufferReuse reuse;  // so that the second run waits for no memory, as little as a large one
  RunOptions unwatched = options;
  unwatched.observer = nullptr;
  unwatched.kept = nullptr;
  unwatched.facts.rehearsal = true;
  pipeline.run(request, unwatched);
  const auto calls = watch(pipeline, request, options);
  calls->bandwidth = measure_bandwidth(calls->load.threads);
  return RunTrace(calls);
}

RunTrace RunTrace::of_reduced(const Pipeline& pipeline, const MatchRequest& request,
                              const RunOptions& options) {
  return of_whole(pipeline, reduced(request), options);
}

RunTrace RunTrace::of_memory(const Pipeline& pipeline, const MatchRequest& request,
                             const RunOptions& options) {
  return RunTrace(watch(pipeline, reduced(request), options));
}

}  // namespace xgm
