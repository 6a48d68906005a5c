// SPDX-License-Identifier: Apache-2.0
#include "xgm/exchange/stored.hpp"

#include "xgm/base/error.hpp"
#include "xgm/base/text.hpp"
#include "xgm/io/image_io.hpp"

namespace xgm::exchange {
namespace {

/// Whether the pattern had it.
bool replace(std::string& pattern, const std::string& placeholder, const std::string& text) {
  bool found = false;
  for (std::size_t at = pattern.find(placeholder); at != std::string::npos;
       at = pattern.find(placeholder, at + text.size())) {
    pattern.replace(at, placeholder.size(), text);
    found = true;
  }
  return found;
}

std::string text(cv::Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

}  // namespace

std::string stored_file(const std::string& pattern, const ImagePair& pair, const Context& context) {
  std::string file = pattern;
  const double scale = context.place().level.scale;
  const bool of_view = replace(file, "{view}", pair.is_reverse ? "right" : "left");
  const bool of_scale = replace(file, "{scale}", short_number(scale));
  const bool of_scene = replace(file, "{scene}", context.run().scene);
  if (of_scene && context.run().scene.empty()) {
    throw Error("'" + pattern +
                "' asks for the name of the scene, and these images have none; "
                "write a file without {scene}");
  }
  if (pair.is_reverse && !of_view) {
    throw Error("'" + pattern +
                "' names one file for both views; put {view} into it, which "
                "becomes left or right");
  }
  if (scale != 1 && !of_scale) {
    throw Error("'" + pattern +
                "' names one file for all levels of a pyramid; put {scale} into "
                "it, or take a matcher without levels");
  }
  return file;
}

cv::Mat1f read_stored(const std::string& file, std::optional<double> divisor, cv::Size size) {
  const cv::Mat1f values = read_disparities(file, divisor).value;
  if (values.size() == size) return values;
  throw Error(file + ": is " + text(values.size()) + ", and the images are " + text(size) +
              " (tiles are parts of them); give a map of their size");
}

}  // namespace xgm::exchange
