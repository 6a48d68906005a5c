// SPDX-License-Identifier: Apache-2.0
#include "pipeline/trace.hpp"

namespace xgm::trace {
namespace {

double count_searched(const VolumeShape& shape) {
  double searched = 0;
  for (int y = 0; y < shape.height(); ++y) {
    for (int x = 0; x < shape.width(); ++x) searched += shape.count(y, x);
  }
  return searched;
}

}  // namespace

Searched mean_searched(const DisparityRange& range, const cv::Mat1b& valid) {
  Searched sum;
  double pixels = 0;
  for (int y = 0; y < range.size().height; ++y) {
    for (int x = 0; x < range.size().width; ++x) {
      if (!valid.empty() && valid(y, x) == 0) continue;
      const int count = range.at(y, x).size();
      sum.cells += Workload::room(count);
      sum.disparities += count;
      ++pixels;
    }
  }
  if (pixels == 0) return {};
  return {sum.cells / pixels, sum.disparities / pixels};
}

void Tracer::stage_begin(const StagePlace& place) {
  Call fresh;
  fresh.place = place;
  fresh.begin = static_cast<int>(events_.size());
  if (open_.empty()) {
    fresh.size = load_.size;
    fresh.planes = load_.planes;
    fresh.range = load_.range;
    fresh.cells_per_pixel = load_.cells_per_pixel;
    fresh.ragged = load_.ragged;
  } else {
    Call& outer = call(open_.back());
    outer.is_leaf = false;
    fresh.parent = open_.back();
    fresh.size = outer.size;
    fresh.planes = outer.planes;
    fresh.range = outer.range;
    fresh.cells_per_pixel = outer.cells_per_pixel;
    fresh.searched = outer.searched;
    fresh.ragged = outer.ragged;
  }
  open_.push_back(static_cast<int>(calls_.size()));
  events_.push_back({Event::What::begin, open_.back()});
  calls_.push_back(std::move(fresh));
}

void Tracer::stage_input(const StagePlace&, const Artifact& input) {
  see(Event::What::take, input);
}

void Tracer::stage_same_as(const StagePlace&, const std::string& earlier) {
  const int here = open_.back();
  for (int i = here - 1; i >= 0 && call(here).same_as < 0; --i) {
    if (call(i).place.path == earlier) call(here).same_as = i;
  }
  if (call(here).same_as >= 0) call(call(here).same_as).kept_until = here;
}

void Tracer::stage_end(const StagePlace&, const StageStatistics& statistics,
                       const Artifact& result) {
  see(Event::What::give, result);
  const int ended = open_.back();
  open_.pop_back();
  call(ended).seconds += statistics.seconds;
  if (!open_.empty()) call(open_.back()).seconds -= statistics.seconds;
  events_.push_back({Event::What::end, ended});
}

void Tracer::see(Event::What what, const Artifact& artifact) {
  if (const auto* const* request = std::get_if<const MatchRequest*>(&artifact)) {
    take_request(**request);
  } else if (const auto* const* pair = std::get_if<const ImagePair*>(&artifact)) {
    see(what, **pair);
  } else if (const auto* const* range = std::get_if<const DisparityRange*>(&artifact)) {
    see(what, **range);
  } else if (const auto* const* costs = std::get_if<const CostVolume*>(&artifact)) {
    see(what, (*costs)->data(),
        {Buffer::Kind::volume, (*costs)->shape().size(), double((*costs)->bytes())});
    see(what, (*costs)->shape());
  } else if (const auto* const* sums = std::get_if<const AggregatedVolume*>(&artifact)) {
    see(what, (*sums)->data(),
        {Buffer::Kind::volume, (*sums)->shape().size(), double((*sums)->bytes())});
    see(what, (*sums)->shape());
  } else if (const auto* const* map = std::get_if<const DisparityMap*>(&artifact)) {
    see(what, **map);
  } else if (const auto* const* maps = std::get_if<const MatchResult*>(&artifact)) {
    see(what, (*maps)->forward);
    if ((*maps)->reverse) see(what, *(*maps)->reverse);
  } else if (const auto* const* confidence = std::get_if<const cv::Mat1f*>(&artifact)) {
    see(what, **confidence);
  }
}

void Tracer::take_request(const MatchRequest& request) {
  Call& here = call(open_.back());
  here.is_matcher = true;
  here.size = request.pair.size();
  here.planes = static_cast<int>(request.pair.base.planes.size());
  here.range = request.range.hull();
  here.ragged = !request.range.is_uniform();
  const Searched searched = mean_searched(request.range, request.pair.base.valid);
  here.cells_per_pixel = searched.cells;
  here.searched = searched.disparities;
  see(Event::What::take, request.pair);
  see(Event::What::take, request.range);
  if (request.reverse_range) see(Event::What::take, *request.reverse_range);
}

void Tracer::see(Event::What what, const ImagePair& pair) {
  for (const Image* image : {&pair.base, &pair.match}) {
    if (image->planes.empty()) continue;
    const double pixels = image->size().area();
    const double bytes = sizeof(float) * static_cast<double>(image->planes.size()) +
                         (image->valid.empty() ? 0.0 : 1.0);
    see(what, image->planes.front().data, {Buffer::Kind::pixels, image->size(), bytes * pixels});
  }
}

void Tracer::see(Event::What what, const DisparityMap& map) {
  constexpr double kMapBytes = sizeof(float) + 1;
  const double pixels = map.size().area();
  see(what, map.disparity.data, {Buffer::Kind::pixels, map.size(), kMapBytes * pixels});
  if (!map.confidence.empty()) see(what, map.confidence);
}

void Tracer::see(Event::What what, const cv::Mat1f& confidence) {
  see(what, confidence.data,
      {Buffer::Kind::pixels, confidence.size(),
       static_cast<double>(confidence.total() * sizeof(float))});
}

void Tracer::see(Event::What what, const DisparityRange& range) {
  if (range.is_uniform()) return;
  see(what, range.data(), {Buffer::Kind::pixels, range.size(), double(range.bytes())});
}

void Tracer::see(Event::What what, const VolumeShape& shape) {
  see(what, &shape, {Buffer::Kind::shape, shape.size(), double(shape.bytes())});
  const double pixels = shape.size().area() * load_.used;
  for (int i = open_.back(); i >= 0; i = call(i).parent) {
    Call& here = call(i);
    if (here.size != shape.size()) break;
    here.has_volumes = true;
    here.cells_per_pixel = static_cast<double>(shape.cells()) / pixels;
    here.searched = count_searched(shape) / pixels;
    if (here.is_matcher) break;
  }
}

/// What is returned is known only if it was seen since the call began: another buffer may lie where
/// one was that is gone.
void Tracer::see(Event::What what, const void* address, Buffer buffer) {
  Call& here = call(open_.back());
  if (buffer.kind == Buffer::Kind::pixels) {
    (what == Event::What::take ? here.given_bytes : here.returned_bytes) += buffer.bytes;
    if (what == Event::What::give && !here.is_matcher) here.size = buffer.size;
  }
  const int now = static_cast<int>(events_.size());
  const auto found = known_.find(address);
  if (found != known_.end()) {
    Buffer& known = buffers_[static_cast<std::size_t>(found->second)];
    const bool alike = known.kind == buffer.kind && known.size == buffer.size;
    if (alike && (what == Event::What::take || known.last_seen >= here.begin)) {
      known.last_seen = now;
      events_.push_back({what, open_.back(), found->second});
      return;
    }
  }
  buffer.call = open_.back();
  buffer.last_seen = now;
  known_[address] = static_cast<int>(buffers_.size());
  events_.push_back({what, open_.back(), static_cast<int>(buffers_.size())});
  buffers_.push_back(buffer);
}

}  // namespace xgm::trace
