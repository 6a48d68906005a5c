// SPDX-License-Identifier: Apache-2.0
// Real scenes of every benchmark, found and read by the data sets, are as the list that came with
// them says (stereo/INDEX.tsv): size, range and density of the truth, masks; and matching pixels of
// both images look alike at the true disparity.
#include <cmath>
#include <fstream>
#include <map>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/scene.hpp"

using namespace xgm;
using namespace xgm::testing;
namespace fs = std::filesystem;

namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, '\t');) cells.push_back(cell);
  return cells;
}

std::vector<Row> read_index(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  REQUIRE(std::getline(stream, line));
  const std::vector<std::string> titles = split(line);
  std::vector<Row> rows;
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = split(line);
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) row[titles[i]] = cells[i];
  }
  return rows;
}

double number(const Row& row, const char* column) { return std::stod(row.at(column)); }

/// Where the scenes of a benchmark have to lie; {s} is the scene, {e} an ending of im0.
struct Layout {
  std::string left, right, truth, reverse;
};

Layout layout_of(const std::string& benchmark, const std::string& scene) {
  if (benchmark.starts_with("middlebury_200") && benchmark != "middlebury_2001") {
    const std::string size = benchmark.ends_with("full")   ? "FullSize"
                             : benchmark.ends_with("half") ? "HalfSize"
                                                           : "ThirdSize";
    const std::string top = size + "/{s}/";
    return {top + "view1{e}", top + "view5{e}", top + "disp1.png", top + "disp5.png"};
  }
  if (scene == "tsukuba") {
    return {"t/{s}/scene1.row3.col3{e}", "t/{s}/scene1.row3.col4{e}",
            "t/{s}/truedisp.row3.col3.png", ""};
  }
  if (benchmark == "middlebury_2001" || benchmark == "middlebury_v2") {
    return {"t/{s}/im2{e}", "t/{s}/im6{e}", "t/{s}/disp2{g}", "t/{s}/disp6{g}"};
  }
  if (benchmark == "kitti2015_training") {
    return {"t/image_2/{s}.png", "t/image_3/{s}.png", "t/disp_occ_0/{s}.png", ""};
  }
  if (benchmark == "sceneflow_flyingthings3d") {
    const std::string images = "t/frames_cleanpass/{s}/", maps = "t/disparity/{s}/";
    return {images + "left/0{e}", images + "right/0{e}", maps + "left/0.pfm", maps + "right/0.pfm"};
  }
  return {};
}

std::string filled(std::string pattern, const Row& row) {
  const std::map<std::string, std::string> gaps{
      {"{s}", row.at("scene")},
      {"{e}", fs::path(row.at("im0")).extension().string()},
      {"{g}", fs::path(row.at("gt")).extension().string()}};
  for (const auto& [gap, text] : gaps) {
    const std::size_t at = pattern.find(gap);
    if (at != std::string::npos) pattern.replace(at, gap.size(), text);
  }
  return pattern;
}

/// Links the scene's files to where the official layout has them; returns the folder to search.
std::string lay_out(const Layout& layout, const Row& row, const fs::path& source,
                    const TemporaryFolder& tree) {
  const auto link = [&](const std::string& pattern, const std::string& file) {
    if (pattern.empty() || !fs::exists(source / file)) return;
    const fs::path target = tree / filled(pattern, row);
    fs::create_directories(target.parent_path());
    fs::create_symlink(source / file, target);
  };
  link(layout.left, row.at("im0"));
  link(layout.right, row.at("im1"));
  link(layout.truth, row.at("gt"));
  link(layout.reverse, "disp1GT" + fs::path(row.at("gt")).extension().string());
  return tree / layout.left.substr(0, layout.left.find('/'));
}

SceneFiles find(const Row& row, const fs::path& source, const TemporaryFolder& tree) {
  const std::string& benchmark = row.at("benchmark");
  if (benchmark == "middlebury_v3_trainingQ" || benchmark == "eth3d_two_view_training") {
    return find_scene(source.parent_path().string(), builtins(), row.at("scene"));
  }
  const Layout layout = layout_of(benchmark, row.at("scene"));
  if (!layout.left.empty()) return find_scene(lay_out(layout, row, source, tree), builtins());
  return find_scene(source.parent_path().string(), builtins(), row.at("scene"),
                    "{type: folder, left: '{scene}/" + row.at("im0") + "', right: '{scene}/" +
                        row.at("im1") + "', truth: '{scene}/" + row.at("gt") +
                        "', truth_divisor: " + row.at("gt_divisor") +
                        ", non_occluded: '{scene}/mask0nocc.png'}");
}

/// Grey levels without their slow changes, so that exposure has no say.
cv::Mat1f details(const Image& image) {
  const cv::Mat1f grey = image.grey();
  cv::Mat1f mean;
  cv::blur(grey, mean, {15, 15});
  return cv::Mat1f(grey - mean);
}

/// Mean difference, 40 at most, between base pixels and where the truth plus `offset` puts them.
double photometric_error(const Scene& scene, const GroundTruth& truth, double offset) {
  const cv::Mat1f left = details(scene.pair.base), right = details(scene.pair.match);
  double sum = 0;
  int count = 0;
  for (int y = 0; y < left.rows; ++y) {
    for (int x = 0; x < left.cols; ++x) {
      const double column = x - double{truth.disparity(y, x)} - offset;
      const bool seen = truth.non_occluded.empty() || truth.non_occluded(y, x) == 255;
      if (!seen || !(column >= 0) || !(column < right.cols - 1)) continue;
      const int whole = static_cast<int>(column);
      const double part = column - whole;
      const double there = (1 - part) * right(y, whole) + part * right(y, whole + 1);
      sum += std::min(40.0, std::abs(left(y, x) - there));
      ++count;
    }
  }
  return sum / count;
}

void check_truth(const Row& row, const GroundTruth& truth) {
  double low = 0, high = 0;
  const cv::Mat1b known(truth.disparity == truth.disparity);  // not NaN
  cv::minMaxIdx(truth.disparity, &low, &high, nullptr, nullptr, known);
  CHECK(low == doctest::Approx(number(row, "disp_min")).epsilon(0.006 / low));
  CHECK(high == doctest::Approx(number(row, "disp_max")).epsilon(0.006 / high));
  const double pixels = static_cast<double>(known.total());
  CHECK(std::abs(100 * cv::countNonZero(known) / pixels - number(row, "gt_density_pct")) <= 0.06);
  if (truth.non_occluded.empty() || row.at("nocc_mask") == "no") return;
  const cv::Mat1b judged(known & (truth.non_occluded == 255));
  const bool derived_here = row.at("nocc_mask") == "official" && !truth.reverse.empty() &&
                            row.at("benchmark") == "middlebury_v2";
  if (derived_here) return;  // its mask is not part of the layout
  CHECK(std::abs(100 * cv::countNonZero(judged) / pixels - number(row, "eval_density_pct")) <=
        0.06);
}

/// The mask made here and the one that was made when the scenes were collected.
void check_derived_mask(const fs::path& file, const GroundTruth& truth) {
  const cv::Mat1b expected = read_mask(file.string(), MaskUse::judged).value;
  REQUIRE(expected.size() == truth.non_occluded.size());
  CHECK(cv::countNonZero(expected != truth.non_occluded) == 0);
}

}  // namespace

TEST_CASE("real scenes are as their list says, read through the official layouts") {
  const auto data = test_data("data sets");
  if (!data) return;
  const std::vector<Row> rows = read_index(*data / "stereo" / "INDEX.tsv");
  CHECK(rows.size() >= 39);
  for (const Row& row : rows) {
    CAPTURE(row.at("benchmark"));
    CAPTURE(row.at("scene"));
    const fs::path source = fs::canonical(*data / "stereo" / row.at("benchmark") / row.at("scene"));
    const TemporaryFolder tree;
    const SceneFiles files = find(row, source, tree);
    const Scene scene = load_scene(files);
    CHECK(scene.pair.size().width == number(row, "width"));
    CHECK(scene.pair.size().height == number(row, "height"));
    if (!row.at("calib_ndisp").empty()) {
      CHECK(files.disparities == Interval{0, static_cast<int>(number(row, "calib_ndisp"))});
    }
    const GroundTruth truth = load_truth(files.truth, scene.pair.size());
    REQUIRE_FALSE(truth.disparity.empty());
    check_truth(row, truth);
    const fs::path derived = source / "mask0nocc_derived.png";
    if (fs::exists(derived)) check_derived_mask(derived, truth);
    const double at_truth = photometric_error(scene, truth, 0);
    for (const auto& beside : {std::pair{"err_m1", -1.0}, {"err_p1", 1.0}}) {
      if (number(row, beside.first) <= number(row, "err_gt")) continue;
      CHECK_MESSAGE(at_truth < photometric_error(scene, truth, beside.second), beside.first);
    }
  }
}
