// SPDX-License-Identifier: Apache-2.0
// ransac_deskew finds the shift of rows that a scene was made with, and takes it away.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <map>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "support/support.hpp"
#include "xgm/synthesis/generate.hpp"
#include "xgm/testing/synthetic.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

/// Keeps what a stage tells.
class Listener final : public Observer {
 public:
  void log(LogLevel level, const StagePlace&, const std::string& text) override {
    (level == LogLevel::warning ? warnings : infos) += text + "\n";
  }
  void figure(const StagePlace&, const std::string& name, double value) override {
    figures[name] = value;
  }

  VerticalShift model() const { return {figures.at("a"), figures.at("b"), figures.at("c")}; }

  std::string infos, warnings;
  std::map<std::string, double> figures;
};

SceneOptions scene_options(const VerticalShift& shift = {}) {
  SceneOptions options;
  options.size = {400, 300};
  options.disparities = {0, 40};
  options.shift = shift;
  options.noise = 1;
  return options;
}

ImagePair deskewed(const ImagePair& pair, Listener& listener,
                   const std::string& yaml = "ransac_deskew") {
  return stage<Preprocess>(yaml)->run(pair, Context(&listener));
}

bool same(const Image& a, const Image& b) {
  if (a.planes.size() != b.planes.size() || a.valid.size() != b.valid.size()) return false;
  for (std::size_t c = 0; c < a.planes.size(); ++c)
    if (a.planes[c].size() != b.planes[c].size() ||
        std::memcmp(a.planes[c].data, b.planes[c].data, a.planes[c].total() * sizeof(float)) != 0)
      return false;
  return a.valid.empty() || cv::norm(a.valid, b.valid, cv::NORM_INF) == 0;
}

/// Largest difference of the models at the corners.
double corner_error(const VerticalShift& found, const VerticalShift& truth, cv::Size size) {
  double worst = 0;
  for (const double x : {0.0, size.width - 1.0})
    for (const double y : {0.0, size.height - 1.0})
      worst = std::max(worst, std::abs(found.at(x, y) - truth.at(x, y)));
  return worst;
}

/// Mean |difference| from the scene without any shift, where `image` has data.
double mean_difference(const Image& image, const Image& aligned) {
  cv::Mat1f difference;
  cv::absdiff(image.planes[0], aligned.planes[0], difference);
  return image.valid.empty() ? cv::mean(difference)[0] : cv::mean(difference, image.valid)[0];
}

/// Texture without end, and the same seen 40 columns to the left, in other rows.
ImagePair large_pair(cv::Size size, const VerticalShift& shift) {
  cv::Mat1b noise(size);
  cv::RNG(1).fill(noise, cv::RNG::UNIFORM, 0, 256);
  cv::Mat1f base, match;
  noise.convertTo(base, CV_32F);
  cv::GaussianBlur(base, base, {}, 2);
  base = (base - 127.5F) * 5 + 127.5F;
  const double slope = 1 / (1 + shift.b);
  const cv::Matx23d place(1, 0, 40, -shift.a * slope, slope, -shift.c * slope);
  cv::warpAffine(base, match, place, size, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
  return {Image(base), Image(match)};
}

/// Counts the pixels that are read.
class CountedPair final : public PairWindows {
 public:
  explicit CountedPair(ImagePair pair) : pair_(std::move(pair)) {}
  cv::Size size() const override { return pair_.size(); }
  ImagePair read(const cv::Rect& window) const override {
    pixels_ += window.area();
    return pair_.read(window);
  }
  int pixels() const { return pixels_; }

 private:
  PairInMemory pair_;
  mutable std::atomic<int> pixels_ = 0;
};

}  // namespace

TEST_CASE("ransac_deskew: recovers dy = 0.01 y + 1.3 to 0.1 px at the corners") {
  const VerticalShift truth{0, 0.01, 1.3};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SceneOptions options = scene_options(truth);
    options.seed = seed;
    Listener listener;
    deskewed(make_scene(options).pair, listener);
    CHECK(corner_error(listener.model(), truth, options.size) < 0.1);
    CHECK(listener.figures.at("inliers") >= 100);
    CHECK(listener.figures.at("inliers") <= listener.figures.at("matches"));
    CHECK(listener.figures.at("dy_median_before") > 1.5);
    CHECK(listener.figures.at("dy_median_after") < 0.15);
    CHECK(listener.figures.at("dy_p90_after") < 0.5);
    CHECK(listener.infos.find("moved") != std::string::npos);
  }
}

TEST_CASE(
    "ransac_deskew: recovers shifts that depend on the column, of either sign, other exposure") {
  for (const VerticalShift& truth :
       {VerticalShift{0.008, -0.004, -2}, VerticalShift{-0.01, 0, 0}, VerticalShift{0, 0, 7.5}}) {
    SceneOptions options = scene_options(truth);
    options.gain = 0.7;
    options.bias = 20;
    options.colour = true;
    Listener listener;
    deskewed(make_scene(options).pair, listener);
    CHECK(corner_error(listener.model(), truth, options.size) < 0.1);
  }
}

TEST_CASE("ransac_deskew: after the warp the match image is that of an aligned pair") {
  const SceneOptions options = scene_options({0.004, 0.01, 1.3});
  const ImagePair aligned = make_scene(scene_options()).pair;
  const ImagePair skewed = make_scene(options).pair;
  Listener listener;
  const ImagePair result = deskewed(skewed, listener);
  CHECK(same(result.base, skewed.base));
  const double before = mean_difference(skewed.match, aligned.match);
  CHECK(before > 7);
  CHECK(mean_difference(result.match, aligned.match) < before / 4);
  Listener again;
  CHECK(same(deskewed(result, again).match, result.match));
  CHECK(again.figures.at("dy_median_before") < 0.15);
}

TEST_CASE("ransac_deskew: exactly the rows that come from outside are masked") {
  const SceneOptions options = scene_options({0, 0, 3.5});
  Listener listener;
  const Image match = deskewed(make_scene(options).pair, listener).match;
  for (int y = 0; y < match.size().height; ++y) {
    CAPTURE(y);
    const auto valid = cv::countNonZero(match.valid.row(y));
    if (y <= 295) CHECK(valid == match.size().width);  // 295 + 3.5 is inside, 296 + 3.5 is not
    if (y >= 297) CHECK(valid == 0);
  }
}

TEST_CASE("ransac_deskew: leaves a clean pair alone, bit by bit, and says so") {
  const ImagePair pair = make_scene(scene_options()).pair;
  Listener listener;
  const ImagePair result = deskewed(pair, listener);
  CHECK(same(result.base, pair.base));
  CHECK(same(result.match, pair.match));
  CHECK(listener.infos.find("left as it is") != std::string::npos);
  CHECK(listener.warnings.empty());
  CHECK(listener.figures.at("dy_median_after") == listener.figures.at("dy_median_before"));
}

TEST_CASE("ransac_deskew: min_correction decides what is clean") {
  const ImagePair pair = make_scene(scene_options({0, 0, 0.6})).pair;
  Listener one, other;
  CHECK(same(deskewed(pair, one, "{type: ransac_deskew, min_correction: 0.7}").match, pair.match));
  CHECK(
      !same(deskewed(pair, other, "{type: ransac_deskew, min_correction: 0.5}").match, pair.match));
}

TEST_CASE("ransac_deskew: warns and leaves alone what has too few key points") {
  for (const cv::Size size :
       {cv::Size(1, 1), cv::Size(200, 1), cv::Size(5, 90), cv::Size(90, 90)}) {
    const ImagePair pair{Image(cv::Mat1f(size, 100.0F)), Image(cv::Mat1f(size, 100.0F))};
    Listener listener;
    CHECK(same(deskewed(pair, listener).match, pair.match));
    CHECK(listener.warnings.find("min_matches") != std::string::npos);
  }
}

TEST_CASE("ransac_deskew: pixels without data neither vote nor leak into others") {
  const VerticalShift truth{0, 0.01, 1.3};
  ImagePair pair = make_scene(scene_options(truth)).pair;
  const cv::Rect hole(60, 40, 120, 150);
  pair.match.valid = cv::Mat1b(pair.size(), 255);
  pair.match.valid(hole) = 0;
  pair.match.planes[0](hole) = std::numeric_limits<float>::quiet_NaN();
  Listener listener;
  const Image match = deskewed(pair, listener).match;
  CHECK(corner_error(listener.model(), truth, pair.size()) < 0.1);
  CHECK(cv::checkRange(match.planes[0]));
  CHECK(match.valid(100, 100) == 0);
  CHECK(match.valid(100, 30) == 255);
  const ImagePair aligned = make_scene(scene_options()).pair;
  CHECK(mean_difference(match, aligned.match) < 3);
}

TEST_CASE("ransac_deskew: false matches do not move the model") {
  // Half of the match image is another scene: whatever matches there is wrong.
  const VerticalShift truth{0, 0.01, 1.3};
  ImagePair pair = make_scene(scene_options(truth)).pair;
  SceneOptions other = scene_options({0, 0, -5});
  other.seed = 9;
  const ImagePair wrong = make_scene(other).pair;
  const cv::Rect bottom(0, 180, 400, 120);
  wrong.base.planes[0](bottom).copyTo(pair.base.planes[0](bottom));
  wrong.match.planes[0](bottom).copyTo(pair.match.planes[0](bottom));
  Listener listener;
  deskewed(pair, listener);
  CHECK(corner_error(listener.model(), truth, cv::Size(400, 180)) < 0.15);
  CHECK(listener.figures.at("inliers") < 0.75 * listener.figures.at("matches"));
}

TEST_CASE("ransac_deskew: what was fitted goes through text to the last bit") {
  for (const double shift : {1.3, 0.0}) {  // a model, and rows that are left as they are
    const ImagePair pair = make_scene(scene_options({shift / 300, shift / 100, shift})).pair;
    const auto deskew = stage<Preprocess>("ransac_deskew");
    Listener listener;
    const auto fitted = deskew->fitted(PairInMemory(pair), Context(&listener));
    const std::string text = fitted->state();
    CAPTURE(text);
    const auto restored = deskew->restored(text, pair.size());
    REQUIRE(restored != nullptr);
    CHECK(restored->margin() == fitted->margin());
    CHECK(restored->state() == text);
    CHECK(same(restored->run(pair, {5, 7}).match, fitted->run(pair, {5, 7}).match));
    CHECK(same(restored->run(pair, {}).match, pair.match) == (shift == 0));
  }
  for (const char* text : {"{}", "{\"a\": 1, \"b\": 2}", "{\"a\": 1, \"b\": 2, \"c\": null}"}) {
    CHECK(stage<Preprocess>("ransac_deskew")->restored(text, {9, 9}) == nullptr);
  }
}

TEST_CASE(
    "ransac_deskew: the result depends neither on threads, OpenCV's included, nor on the run") {
  const ImagePair pair = make_scene(scene_options({0.003, 0.01, 1.3})).pair;
  Listener listener;
  const ImagePair first = deskewed(pair, listener);
  const int threads_of_opencv = cv::getNumThreads();
  for (const int count : {1, 2, 3, 8}) {
    const xgm::ThreadLimit threads(count);
    for (const int opencv : {1, 2, 5}) {
      cv::setNumThreads(opencv);
      CHECK(same(deskewed(pair, listener).match, first.match));
    }
  }
  cv::setNumThreads(threads_of_opencv);
}

TEST_CASE("ransac_deskew: images of many tiles are matched across tile borders") {
  SceneOptions options = scene_options({0.001, 0.002, -3});
  options.size = {1500, 1100};
  options.disparities = {-90, 10};
  Listener listener;
  deskewed(make_scene(options).pair, listener);
  CHECK(corner_error(listener.model(), options.shift, options.size) < 0.1);
}

TEST_CASE("ransac_deskew: of an image of more than 16 megapixels no more are looked at") {
  const VerticalShift truth{-0.0003, 0.001, 1.3};
  const cv::Size size(6500, 5000);
  const CountedPair pair(large_pair(size, truth));
  Listener listener;
  const auto fitted = stage<Preprocess>("ransac_deskew")->fitted(pair, Context(&listener));
  CHECK(corner_error(listener.model(), truth, size) < 0.1);
  CHECK(listener.figures.at("inliers") > 1000);
  const double read_of_each = pair.pixels() / 2.0;
  CHECK(read_of_each > 16e6);
  CHECK(read_of_each < 1.45 * (16 << 20));  // tiles are seen with a margin
}

TEST_CASE("ransac_deskew: of an image of more than a megapixel half the size is enough") {
  const VerticalShift truth{-0.0008, 0.002, 1.3};
  for (const cv::Size size : {cv::Size(1280, 1024), cv::Size(1401, 1003), cv::Size(900, 1501)}) {
    CAPTURE(size);
    SceneOptions options = scene_options(truth);
    options.size = size;
    ImagePair pair = make_scene(options).pair;
    Listener whole;
    deskewed(pair, whole);
    CHECK(corner_error(whole.model(), truth, size) < 0.1);
    CHECK(whole.figures.at("inliers") > 1000);
    // What has no data neither votes nor leaks into the pixels that are reduced with it.
    pair.match.valid = cv::Mat1b(size, 255);
    const cv::Rect hole(201, 301, 401, 501);
    pair.match.valid(hole) = 0;
    pair.match.planes[0](hole) = std::numeric_limits<float>::quiet_NaN();
    Listener masked;
    const Image match = deskewed(pair, masked).match;
    CHECK(corner_error(masked.model(), truth, size) < 0.1);
    CHECK(masked.figures.at("inliers") < whole.figures.at("inliers"));
    CHECK(cv::checkRange(match.planes[0]));
  }
}

TEST_CASE("ransac_deskew: a strip of more than a megapixel is looked at as it is") {
  const VerticalShift truth{0, 0, 1.3};
  for (const int rows : {17, 40, 255}) {
    SceneOptions options = scene_options(truth);
    options.size = {1400000 / rows, rows};  // up to 82352 px wide
    Listener listener;
    const Image match = deskewed(make_scene(options).pair, listener).match;
    CAPTURE(rows);
    CHECK(corner_error(listener.model(), truth, options.size) <
          0.3);  // 17 rows tell little of the slope
    options.shift = {};
    CHECK(mean_difference(match, make_scene(options).pair.match) < 3);
  }
}

TEST_CASE("ransac_deskew: recovers dy = 0.01 y + 1.3 to 0.1 px in rooms full of things") {
  for (std::uint64_t seed = 21; seed <= 24; ++seed) {
    synthesis::Options options;  // 640 x 480, 64 disparities
    options.seed = seed;
    synthesis::plant(options.faults, "vertical=0,0.01,1.3");
    Listener listener;
    deskewed(synthesis::generate(options).pair, listener);
    const double error = corner_error(listener.model(), options.faults.vertical, options.size);
    MESSAGE("seed ", seed, ": ", error, " px at the worst corner");
    CHECK(error < 0.1);
  }
}

namespace {

struct Features {
  std::vector<cv::KeyPoint> points;
  cv::Mat1f descriptors;
};

Features features(const Image& image) {
  cv::Mat1b grey;
  image.grey().convertTo(grey, CV_8U);
  Features found;
  cv::SIFT::create(4000, 3, 0.01)->detectAndCompute(grey, {}, found.points, found.descriptors);
  return found;
}

/// Best matches by OpenCV, -1 where the second best is nearly as good.
std::vector<int> best(const Features& from, const Features& to) {
  std::vector<std::vector<cv::DMatch>> nearest;
  cv::BFMatcher(cv::NORM_L2).knnMatch(from.descriptors, to.descriptors, nearest, 2);
  std::vector<int> matches;
  for (const auto& two : nearest) {
    const bool clear = double(two[0].distance) < 0.8 * double(two[1].distance);
    matches.push_back(clear ? two[0].trainIdx : -1);
  }
  return matches;
}

}  // namespace

TEST_CASE("ransac_deskew matches as many key points as OpenCV's exhaustive matcher") {
  const ImagePair pair = make_scene(scene_options({0.0, 0.0, 2.0})).pair;
  const Features base = features(pair.base), match = features(pair.match);
  const std::vector<int> there = best(base, match), back = best(match, base);
  int mutual = 0;
  for (int i = 0; i < int(there.size()); ++i) {
    const int j = there[std::size_t(i)];
    if (j < 0 || back[std::size_t(j)] != i) continue;
    mutual += std::abs(double(base.points[std::size_t(i)].pt.y) -
                       double(match.points[std::size_t(j)].pt.y)) <= 16;
  }
  REQUIRE(mutual > 100);
  Listener listener;
  deskewed(pair, listener);
  CHECK(listener.figures.at("matches") == mutual);
}
