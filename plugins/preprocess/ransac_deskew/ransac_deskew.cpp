// SPDX-License-Identifier: Apache-2.0
// Aligns the rows of an imperfectly rectified pair (section 5 of the paper).
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "plugins/preprocess/ransac_deskew/key_points.hpp"
#include "plugins/preprocess/ransac_deskew/row_model.hpp"
#include "plugins/preprocess/ransac_deskew/warp.hpp"
#include "xgm/base/json.hpp"
#include "xgm/plugin.hpp"

namespace {

using namespace xgm::ransac_deskew;

/// The smallest value that at least `share` of the values do not exceed.
double quantile(std::vector<double> values, double share) {
  const double rank = std::ceil(share * static_cast<double>(values.size())) - 1;
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 0.0));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

/// |dy| of the points, less what the model explains.
std::vector<double> residuals(const std::vector<Correspondence>& points, const RowModel& model) {
  std::vector<double> values;
  for (const Correspondence& p : points) values.push_back(std::abs(p.dy - model.at(p.x, p.y)));
  return values;
}

/// Median |dy| of the model over the image.
double typical_shift(const RowModel& model, cv::Size size) {
  constexpr int kGrid = 32;
  std::vector<double> values;
  for (int i = 0; i < kGrid; ++i)
    for (int j = 0; j < kGrid; ++j)
      values.push_back(std::abs(
          model.at((j + 0.5) / kGrid * size.width - 0.5, (i + 0.5) / kGrid * size.height - 0.5)));
  return quantile(std::move(values), 0.5);
}

std::string pixels(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f px", value);
  return text;
}

/// Largest |dy| of the model in the image: it is linear, so a corner has it.
double largest_shift(const RowModel& model, cv::Size size) {
  const double right = size.width - 1, bottom = size.height - 1;
  return std::max({std::abs(model.at(0, 0)), std::abs(model.at(right, 0)),
                   std::abs(model.at(0, bottom)), std::abs(model.at(right, bottom))});
}

/// Moves rows of parts by the model of the whole scene.
class DeskewOfParts final : public xgm::PartPreprocess {
 public:
  DeskewOfParts(std::optional<RowModel> model, cv::Size scene)
      : model_(model), margin_(model ? cvCeil(largest_shift(*model, scene)) + kCubicRows : 0) {}

  int margin() const override { return margin_; }
  xgm::ImagePair run(const xgm::ImagePair& part, cv::Point origin) const override {
    if (!model_) return part;
    return {part.base, warp_rows(part.match, *model_, origin), part.is_reverse};
  }
  std::string state() const override {
    if (!model_) return xgm::Json{{"rows", "left as they are"}}.dump();
    return xgm::Json{{"a", model_->a}, {"b", model_->b}, {"c", model_->c}}.dump();
  }

 private:
  static constexpr int kCubicRows = 2;
  std::optional<RowModel> model_;
  int margin_;
};

class RansacDeskew final : public xgm::Preprocess, public xgm::StatesNeeds {
 public:
  struct Parameters {
    int key_points = 4000;
    double ratio = 0.8;
    double max_dy = 16;
    int iterations = 1000;
    double threshold = 1;
    int min_matches = 30;
    double min_correction = 0.15;
    int seed = 1;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("key_points", p.key_points, "How many key points to look for in each image.")
        .range(100, 1e6);
    set.add(
           "ratio", p.ratio,
           "A key point's best match must be closer than this share of the second best's distance.")
        .range(0.1, 1);
    set.add("max_dy", p.max_dy, "Matches whose rows are further apart are taken to be false.")
        .unit("px")
        .range(0.5, 1000);
    set.add("iterations", p.iterations, "How many random samples RANSAC draws.").range(1, 1e6);
    set.add("threshold", p.threshold, "Matches this close to a model vote for it.")
        .unit("px")
        .range(0.01, 100);
    set.add("min_matches", p.min_matches,
            "With fewer matches that agree the pair is left as it is, with a warning.")
        .range(3, 1e6);
    set.add("min_correction", p.min_correction,
            "If the typical shift of rows is smaller the pair is left as it is.")
        .unit("px")
        .range(0, 100);
    set.add("seed", p.seed, "Start of the random numbers; the same seed gives the same result.")
        .range(0, 1e9);
  }

  explicit RansacDeskew(const Parameters& parameters) : p_(parameters) {}

  xgm::ImagePair run(const xgm::ImagePair& pair, const xgm::Context& context) const override {
    const auto model = find_model(xgm::PairInMemory(pair), context);
    if (!model) return pair;
    return {pair.base, warp_rows(pair.match, *model), pair.is_reverse};
  }

  std::shared_ptr<const xgm::PartPreprocess> fitted(const xgm::PairWindows& scene,
                                                    const xgm::Context& context) const override {
    return std::make_shared<DeskewOfParts>(find_model(scene, context), scene.size());
  }

  std::shared_ptr<const xgm::PartPreprocess> restored(const std::string& text,
                                                      cv::Size scene) const override {
    const xgm::Json state = xgm::Json::parse(text);
    if (state.contains("rows")) return std::make_shared<DeskewOfParts>(std::nullopt, scene);
    for (const char* name : {"a", "b", "c"}) {
      if (!state.contains(name) || !state.at(name).is_number()) return nullptr;
    }
    const auto number = [&](const char* name) { return state.at(name).number(); };
    return std::make_shared<DeskewOfParts>(RowModel{number("a"), number("b"), number("c")}, scene);
  }

  /// The base image stays as it is; the match image is warped, and gets a mask, when all that the
  /// key points needed is free again.
  xgm::Needs needs(const xgm::Workload& load) const override {
    const double warped = load.image_bytes() + (load.masked ? 0 : load.pixels());
    const double key_points = xgm::ransac_deskew::key_point_bytes(load.size, load.threads);
    return {.working = std::max(0.0, key_points - warped),
            .updates = xgm::ransac_deskew::key_point_pixels(load.size)};
  }

 private:
  std::size_t enough() const { return static_cast<std::size_t>(p_.min_matches); }

  /// How rows of the match image are to be moved; none if the pair is to be left as it is.
  std::optional<RowModel> find_model(const xgm::PairWindows& pair,
                                     const xgm::Context& context) const {
    const auto matches = match_key_points(pair, {p_.key_points, p_.ratio, p_.max_dy});
    context.figure("matches", static_cast<double>(matches.size()));
    if (matches.size() < enough()) return leave_unmatched(matches.size(), context);

    auto agreeing =
        consensus(matches, {p_.iterations, p_.threshold, static_cast<std::uint64_t>(p_.seed)});
    agreeing = inliers(matches, fit(agreeing), p_.threshold);
    context.figure("inliers", static_cast<double>(agreeing.size()));
    if (agreeing.size() < enough()) return leave_unmatched(agreeing.size(), context);

    const RowModel model = fit(agreeing);
    const double shift = typical_shift(model, pair.size());
    const bool correct = shift >= p_.min_correction;
    report(model, agreeing, correct, context);
    if (!correct) {
      context.info("rows align already (typical shift " + pixels(shift) + " by " +
                   std::to_string(agreeing.size()) + " matches): the pair is left as it is");
      return std::nullopt;
    }
    context.info("rows of the match image are moved by " + pixels(shift) + " (median; " +
                 std::to_string(agreeing.size()) + " of " + std::to_string(matches.size()) +
                 " matches agree)");
    return model;
  }

  std::optional<RowModel> leave_unmatched(std::size_t count, const xgm::Context& context) const {
    context.warn("only " + std::to_string(count) + " key points match, fewer than min_matches " +
                 std::to_string(p_.min_matches) + ": the pair is left as it is");
    return std::nullopt;
  }

  /// dy = a * x + b * y + c, and |dy| of the matches that agree with it.
  void report(const RowModel& model, const std::vector<Correspondence>& agreeing, bool correct,
              const xgm::Context& context) const {
    context.figure("a", model.a);
    context.figure("b", model.b);
    context.figure("c", model.c);
    const auto before = residuals(agreeing, {});
    const auto after = residuals(agreeing, correct ? model : RowModel{});
    context.figure("dy_median_before", quantile(before, 0.5));
    context.figure("dy_p90_before", quantile(before, 0.9));
    context.figure("dy_median_after", quantile(after, 0.5));
    context.figure("dy_p90_after", quantile(after, 0.9));
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<RansacDeskew>(
      "ransac_deskew",
      "Aligns the rows of the match image with those of the base image by a linear model.",
      "Fischler, Bolles: Random sample consensus, CACM 1981; Lowe: Distinctive image features from "
      "scale-invariant keypoints, IJCV 2004");
}
