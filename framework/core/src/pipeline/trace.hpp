// SPDX-License-Identifier: Apache-2.0
// A run as it was seen: the calls of its stages and the buffers that went in and out of them.
#pragma once

#include <map>
#include <vector>

#include "xgm/pipeline/plan.hpp"
#include "xgm/stage/observer.hpp"

namespace xgm::trace {

/// Memory that a stage was given or returned, known by its address.
struct Buffer {
  enum class Kind { pixels, shape, volume };
  Kind kind = Kind::pixels;
  cv::Size size;      ///< px
  double bytes = 0;   ///< in this run
  int call = -1;      ///< in which it was seen first
  int last_seen = 0;  ///< index of the last event that it was in
};

struct Event {
  enum class What { begin, take, give, end };
  What what;
  int call;
  int buffer = -1;  ///< that the call is given or returns
};

/// One call of one stage.
struct Call {
  StagePlace place;
  int parent = -1;  ///< the call around it; -1: the pipeline
  int begin = 0;    ///< index of the event
  bool is_leaf = true;
  bool is_matcher = false;  ///< was given a request
  int same_as = -1;         ///< the call whose result it was given; -1: it ran itself
  int kept_until = -1;      ///< the last call that was given its result
  cv::Size size;            ///< of the images or maps that it worked on, px
  int planes = 1;
  Interval range;              ///< hull of what the matcher around was asked to search
  double cells_per_pixel = 0;  ///< of the volumes of the matcher around, else of its ranges
  double searched = 0;         ///< disparities per pixel, likewise
  bool ragged = false;
  bool has_volumes = false;
  double seconds = 0;                          ///< without the stages inside
  double given_bytes = 0, returned_bytes = 0;  ///< of images, maps and ranges
};

/// Means over the pixels that have data.
struct Searched {
  double cells = 0;  ///< disparities, rounded up as volumes are
  double disparities = 0;
};
Searched mean_searched(const DisparityRange& range, const cv::Mat1b& valid);

/// Watches one run.
class Tracer final : public Observer {
 public:
  explicit Tracer(const Workload& load) : load_(load) {}

  void stage_begin(const StagePlace& place) override;
  void stage_input(const StagePlace& place, const Artifact& input) override;
  void stage_same_as(const StagePlace& place, const std::string& earlier) override;
  void stage_end(const StagePlace& place, const StageStatistics& statistics,
                 const Artifact& result) override;

  std::vector<Call> take_calls() { return std::move(calls_); }
  std::vector<Buffer> take_buffers() { return std::move(buffers_); }
  std::vector<Event> take_events() { return std::move(events_); }

 private:
  Call& call(int i) { return calls_[static_cast<std::size_t>(i)]; }
  void see(Event::What what, const Artifact& artifact);
  void see(Event::What what, const ImagePair& pair);
  void see(Event::What what, const DisparityMap& map);
  void see(Event::What what, const cv::Mat1f& confidence);
  void see(Event::What what, const DisparityRange& range);
  void see(Event::What what, const VolumeShape& shape);
  void see(Event::What what, const void* address, Buffer buffer);
  void take_request(const MatchRequest& request);

  Workload load_;
  std::vector<Call> calls_;
  std::vector<Buffer> buffers_;
  std::vector<Event> events_;
  std::vector<int> open_;  ///< calls that run now, outermost first
  std::map<const void*, int> known_;
};

}  // namespace xgm::trace

namespace xgm {

struct RunTrace::Calls {
  Pipeline pipeline;  ///< whose stages the calls name
  Workload load;      ///< of the small pair
  std::vector<trace::Call> calls;
  std::vector<trace::Buffer> buffers;
  std::vector<trace::Event> events;
  double bandwidth = 0;  ///< bytes per second, read and written ones, of all threads together
};

}  // namespace xgm
