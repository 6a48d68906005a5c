// SPDX-License-Identifier: Apache-2.0
// A program that answers what external stages ask, for tests: block matching, its costs, and a
// filter that takes away what lies at the border.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>

#include "io/npy.hpp"
#include "xgm/base/json.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"

using xgm::Json;

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

class Question {
 public:
  explicit Question(const std::string& file)
      : folder_(std::filesystem::path(file).parent_path()),
        json_(Json::parse(xgm::read_file(file))) {}

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  const Json& json() const { return json_; }
  xgm::ImagePair pair() const {
    return xgm::read_pair({.left = image("base", "image"),
                           .right = image("match", "image"),
                           .left_mask = image("base", "mask"),
                           .right_mask = image("match", "mask")})
        .pair;
  }
  int first() const { return static_cast<int>(json_.at("disparities").elements()[0].number()); }
  int last() const { return static_cast<int>(json_.at("disparities").elements()[1].number()); }
  cv::Mat1f array(const std::string& name) const {
    const xgm::NpyArray stored = xgm::read_npy(file(name));
    cv::Mat1f values(static_cast<int>(stored.shape[0]), static_cast<int>(stored.shape[1]));
    std::size_t i = 0;
    for (float& value : values) value = static_cast<float>(stored.at(i++));
    return values;
  }

 private:
  std::string image(const char* view, const char* what) const {
    const Json* name = json_.at(view).find(what);
    return name == nullptr ? "" : file(name->text());
  }

  std::filesystem::path folder_;
  Json json_;
};

/// Mean absolute difference of the valid pixels of 5 x 5 around (x, y) and (x - d, y).
float difference(const xgm::ImagePair& pair, int y, int x, int d) {
  float sum = 0, count = 0;
  for (int v = std::max(0, y - 2); v < std::min(pair.size().height, y + 3); ++v) {
    for (int u = std::max(0, x - 2); u < std::min(pair.size().width, x + 3); ++u) {
      const bool seen = u - d >= 0 && u - d < pair.size().width && pair.base.is_valid(v, u) &&
                        pair.match.is_valid(v, u - d);
      if (!seen) continue;
      sum += std::abs(pair.base.planes[0](v, u) - pair.match.planes[0](v, u - d));
      ++count;
    }
  }
  return count > 0 ? sum / count : kNone;
}

void match(const Question& question) {
  const xgm::ImagePair pair = question.pair();
  cv::Mat1f disparity(pair.size(), kNone);
  for (int y = 0; y < disparity.rows; ++y) {
    for (int x = 0; x < disparity.cols; ++x) {
      float best = std::numeric_limits<float>::infinity();
      for (int d = question.first(); d <= question.last(); ++d) {
        const float cost = x - d >= 0 && x - d < disparity.cols ? difference(pair, y, x, d) : kNone;
        if (!(cost < best)) continue;
        best = cost;
        disparity(y, x) = static_cast<float>(d);
      }
    }
  }
  xgm::write_npy(question.file("disparity.npy"), disparity);
}

/// As numpy.save() writes an array of three axes.
void save(const std::string& file, const std::vector<int>& shape,
          const std::vector<float>& values) {
  std::string text = "{'descr': '<f4', 'fortran_order': False, 'shape': (" +
                     std::to_string(shape[0]) + ", " + std::to_string(shape[1]) + ", " +
                     std::to_string(shape[2]) + "), }\n";
  const std::string magic("\x93NUMPY\x01\x00", 8);
  const char length[]{static_cast<char>(text.size() & 0xff), static_cast<char>(text.size() >> 8)};
  xgm::write_file(file, [&](std::ostream& stream) {
    stream << magic << std::string(length, 2) << text;
    stream.write(reinterpret_cast<const char*>(values.data()),
                 static_cast<std::streamsize>(values.size() * sizeof(float)));
  });
}

void compute_costs(const Question& question) {
  const xgm::ImagePair pair = question.pair();
  const cv::Size size = pair.size();
  std::vector<float> costs;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      for (int d = question.first(); d <= question.last(); ++d) {
        const int seen = x - d;
        const bool outside = seen < 0 || seen >= size.width || !pair.base.is_valid(y, x) ||
                             !pair.match.is_valid(y, seen);
        costs.push_back(
            outside ? kNone : std::abs(pair.base.planes[0](y, x) - pair.match.planes[0](y, seen)));
      }
    }
  }
  const int depth = question.last() - question.first() + 1;
  save(question.file("cost.npy"), {size.height, size.width, depth}, costs);
}

void filter(const Question& question) {
  cv::Mat1f disparity = question.array(question.json().at("map").at("disparity").text());
  disparity.col(0) = kNone;
  xgm::write_npy(question.file("disparity.npy"), disparity);
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) {
    std::cerr << "usage: honest_program match|cost|filter REQUEST\n";
    return 2;
  }
  const std::string task = words[1];
  const Question question(words[2]);
  if (task == "match") match(question);
  if (task == "cost") compute_costs(question);
  if (task == "filter") filter(question);
  return 0;
}
