// SPDX-License-Identifier: Apache-2.0
#include "contract_support.hpp"

#include <limits>

#include "xgm/testing/random.hpp"
#include "xgm/testing/synthetic.hpp"

namespace xgm::testing::detail {
namespace {

std::string place_of(int y, int x) {
  return " (x " + std::to_string(x) + ", y " + std::to_string(y) + ")";
}

}  // namespace

void Report::with(const std::string& name, const std::function<void()>& body) {
  input_ = name;
  told_.clear();
  of_input_.clear();
  watch_.begin(name);
  try {
    if (!watch_.only_names) body();
  } catch (const std::exception& error) {
    fail("it throws", std::string(": ") + error.what());
  } catch (...) {
    fail("it throws", " something that is no exception");
  }
  watch_.end(of_input_);
}

void Report::expect(bool holds, const char* rule) {
  if (!holds) fail(rule, "");
}

void Report::expect(bool holds, const char* rule, int y, int x) {
  if (!holds) fail(rule, place_of(y, x));
}

void Report::expect_none(const std::optional<Fault>& fault) {
  if (fault) fail(fault->rule, fault->pixel ? place_of(fault->pixel->y, fault->pixel->x) : "");
}

void Report::fail(const std::string& rule, const std::string& place) {
  if (!told_.insert(rule).second) return;
  of_input_.push_back(rule + place);
  violations_.push_back(input_ + ": " + rule + place);
}

double chance(std::uint64_t key, int y, int x, int d) {
  const auto bits = [](int value) { return static_cast<std::uint64_t>(value); };
  using namespace random_bits;
  return unit(mix(mix(mix(mix(key) + bits(y)) + bits(x)) + bits(d)));
}

DisparityRange ragged_range(cv::Size size, Interval hull) {
  return DisparityRange::of_pixels(size, [&](int y, int x) {
    const int count = static_cast<int>(chance(1, y, x) * hull.size() * 0.7);
    const int begin = hull.begin + static_cast<int>(chance(2, y, x) * (hull.size() - count));
    return Interval{begin, begin + count};
  });
}

cv::Mat1b mask_with_holes(cv::Size size, int phase) {
  cv::Mat1b mask(size, 255);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      if (((x + phase) / 5 + 3 * (y / 4)) % 7 == 0) mask(y, x) = 0;
  return mask;
}

ImagePair with_levels_under_masks(const ImagePair& pair, float level) {
  ImagePair result = pair;
  for (Image* image : {&result.base, &result.match}) {
    for (cv::Mat1f& plane : image->planes) {
      plane = plane.clone();
      if (!image->valid.empty()) plane.setTo(level, image->valid == 0);
    }
  }
  return result;
}

cv::Mat1f some_confidence(const DisparityMap& map) {
  cv::Mat1f confidence(map.size(), std::numeric_limits<float>::quiet_NaN());
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (map.at(y, x) != Status::matched || chance(80, y, x) < 0.1) continue;
      confidence(y, x) = static_cast<float>(chance(81, y, x));
    }
  }
  return confidence;
}

std::vector<Input> inputs() {
  std::vector<Input> result;
  const auto add = [&](const char* name, cv::Size size, Interval interval, bool colour) {
    SceneOptions options;
    options.size = size;
    options.disparities = interval;
    options.colour = colour;
    const ImagePair pair = make_scene(options).pair;
    result.push_back({name, pair, DisparityRange::uniform(size, interval)});
  };
  add("grey image", {49, 37}, {0, 12}, false);
  add("colour image", {38, 29}, {0, 9}, true);
  add("range of both signs", {49, 23}, {-7, 6}, false);
  add("range far below zero", {33, 21}, {-11, -4}, false);
  add("range wider than the image", {13, 7}, {-40, 70}, false);
  add("range beyond the image", {13, 7}, {40, 70}, false);
  add("one disparity", {31, 19}, {3, 4}, false);
  add("image of one pixel", {1, 1}, {0, 5}, false);
  add("colour image of one pixel", {1, 1}, {-2, 1}, true);
  add("image of one row", {40, 1}, {0, 8}, false);
  add("image of one column", {1, 40}, {0, 8}, false);

  Input masked = result.front();
  masked.name = "masked image";
  masked.pair.base.valid = mask_with_holes(masked.pair.size(), 0);
  masked.pair.match.valid = mask_with_holes(masked.pair.size(), 3);
  Input blank = result.front();
  blank.name = "image without any data";
  blank.pair.base.valid = blank.pair.match.valid = cv::Mat1b::zeros(blank.pair.size());
  result.push_back(blank);
  result.push_back(masked);
  masked.name = "masked image with a range per pixel";
  masked.range = ragged_range(masked.pair.size(), {-3, 14});
  result.push_back(masked);
  return result;
}

namespace {

void append(Bytes& bytes, const void* data, std::size_t count) {
  bytes.append(static_cast<const char*>(data), count);
}

void append(Bytes& bytes, const cv::Mat& mat) {
  const std::array<int, 3> head{mat.rows, mat.cols, mat.type()};
  append(bytes, head.data(), sizeof head);
  for (int y = 0; y < mat.rows; ++y)
    append(bytes, mat.ptr(y), static_cast<std::size_t>(mat.cols) * mat.elemSize());
}

template <class Cell>
Bytes bytes_of_cells(const Volume<Cell>& volume, int extra) {
  Bytes bytes;
  append(bytes, &extra, sizeof extra);
  for (int y = 0; y < volume.shape().height(); ++y) {
    for (int x = 0; x < volume.shape().width(); ++x) {
      const auto cells = volume.cells(y, x);
      append(bytes, cells.data(), cells.size_bytes());
    }
  }
  return bytes;
}

}  // namespace

Bytes bytes_of(const Image& image) {
  Bytes bytes;
  for (const cv::Mat1f& plane : image.planes) append(bytes, plane);
  append(bytes, image.valid);
  return bytes;
}

Bytes bytes_of(const ImagePair& pair) { return bytes_of(pair.base) + bytes_of(pair.match); }

Bytes bytes_of(const cv::Mat1f& values) {
  Bytes bytes;
  append(bytes, values);
  return bytes;
}

Bytes bytes_of(const DisparityMap& map) {
  Bytes bytes;
  append(bytes, map.disparity);
  append(bytes, map.status);
  append(bytes, map.confidence);
  return bytes;
}

Bytes bytes_of(const MatchResult& result) {
  return bytes_of(result.forward) + (result.reverse ? bytes_of(*result.reverse) : Bytes{});
}

Bytes bytes_of(const DisparityRange& range) {
  Bytes bytes;
  for (int y = 0; y < range.size().height; ++y) {
    for (int x = 0; x < range.size().width; ++x) {
      const Interval interval = range.at(y, x);
      append(bytes, &interval, sizeof interval);
    }
  }
  return bytes;
}

Bytes bytes_of(const CostVolume& volume) { return bytes_of_cells(volume, volume.max_cost); }

Bytes bytes_of(const AggregatedVolume& volume) {
  return bytes_of_cells(volume, volume.fraction_bits);
}

}  // namespace xgm::testing::detail
