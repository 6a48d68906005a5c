// SPDX-License-Identifier: Apache-2.0
// Pairs whose cameras stand well to each other, and that were taken under like conditions; those
// closest in time first. The bounds of the angles follow Facciolo, de Franchis, Meinhardt-Llopis:
// Automatic 3D reconstruction from multi-date satellite images (CVPRW 2017).
#include <algorithm>
#include <array>
#include <cmath>

#include "xgm/geo/image/pair_figures.hpp"
#include "xgm/geo/stage/pairs.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

using Figure = std::optional<double>;

/// A pair, and what decides about it.
struct Candidate {
  PairChoice pair;
  PairFigures figures;
};

/// Those closest in time, then those nearest to the best angle. What is unknown comes last.
bool is_better(const Candidate& one, const Candidate& other) {
  const PairFigures &a = one.figures, &b = other.figures;
  constexpr double kBest = 20;  // degrees
  const auto distance = [](const PairFigures& f) {
    return f.convergence ? std::abs(*f.convergence - kBest) : 90;
  };
  const double days_a = std::floor(a.days.value_or(1e9)), days_b = std::floor(b.days.value_or(1e9));
  if (days_a != days_b) return days_a < days_b;
  return distance(a) < distance(b);
}

class ByGeometry final : public Pairs {
 public:
  struct Parameters {
    double min_convergence = 5, max_convergence = 45;
    double max_incidence = 40;
    double max_days = 100000;
    double max_sun_difference = 180;
    double max_cloud_cover = 0.5;
    double min_overlap = 0.1;
    int max_pairs = 50;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    set.add("min_convergence", p.min_convergence,
            "Smallest angle between the lines of sight: below it heights become uncertain.")
        .unit("degrees")
        .range(0, 180);
    set.add("max_convergence", p.max_convergence,
            "Largest angle between the lines of sight: above it the images look too unlike.")
        .unit("degrees")
        .range(0, 180);
    set.add("max_incidence", p.max_incidence, "Of each image, from straight above.")
        .unit("degrees")
        .range(0, 90);
    set.add("max_days", p.max_days, "Largest time between the two; by default any.")
        .unit("days")
        .range(0, 100000);
    set.add("max_sun_difference", p.max_sun_difference,
            "Largest angle between the directions to the sun, so that shadows are alike; by "
            "default any.")
        .unit("degrees")
        .range(0, 180);
    set.add("max_cloud_cover", p.max_cloud_cover, "Of each image, a share.").range(0, 1);
    set.add("min_overlap", p.min_overlap,
            "Share of one of the images that the other one has to show, on ground of the height at "
            "which it shows most.")
        .range(0, 1);
    set.add("max_pairs", p.max_pairs, "Of the pairs that fit, so many: those closest in time.")
        .range(1, 1000000);
    set.rule({"max_convergence", "min_convergence"}, "must not be below min_convergence",
             [&p] { return p.max_convergence >= p.min_convergence; });
  }

  explicit ByGeometry(Parameters parameters) : p_(parameters) {}

  std::vector<PairChoice> run(const std::vector<SatelliteImage>& images,
                              const Context& context) const override {
    std::array<int, 6> refused{};
    std::vector<char> fits;
    for (const SatelliteImage& image : images) fits.push_back(fits_alone(image, context));
    std::vector<Candidate> chosen;
    for (std::size_t i = 0; i < images.size(); ++i) {
      for (std::size_t j = i + 1; j < images.size(); ++j) {
        const PairFigures f = pair_figures(images[i], images[j]);
        tell(images[i].name + " " + images[j].name, f, context);
        const int fault = fits[i] != 0 && fits[j] != 0 ? fault_of(f) : 0;
        if (fault >= 0) {
          ++refused[static_cast<std::size_t>(fault)];
        } else {
          chosen.push_back({{i, j}, f});
        }
      }
    }
    if (chosen.empty()) throw Error("no pair of the images is fit for matching: " + text(refused));
    std::ranges::stable_sort(chosen, is_better);
    chosen.resize(std::min(chosen.size(), static_cast<std::size_t>(p_.max_pairs)));
    std::vector<PairChoice> pairs;
    for (const Candidate& candidate : chosen) pairs.push_back(candidate.pair);
    context.figure("pairs", static_cast<double>(pairs.size()));
    return pairs;
  }

 private:
  /// Tells the figures of an image, too, and what is not known of it.
  bool fits_alone(const SatelliteImage& image, const Context& context) const {
    const Acquisition& a = image.acquisition;
    const auto view = view_of(image);
    const Figure incidence = view ? Figure(view->incidence) : std::nullopt;
    std::string unknown;
    const auto look = [&](const Figure& value, const char* name) {
      if (value) {
        context.figure(image.name + " " + name, *value);
      } else {
        unknown += (unknown.empty() ? "" : ", ") + std::string(name);
      }
    };
    look(incidence, "incidence_deg");
    look(a.time, "time_s");
    look(a.sun_azimuth, "sun_azimuth_deg");
    look(a.sun_elevation, "sun_elevation_deg");
    look(a.cloud_cover, "cloud_cover");
    if (!unknown.empty()) {
      context.warn(image.name + ": unknown are " + unknown +
                   "; its pairs pass what is asked of them (the vendor's metadata, .IMD or "
                   "DIM_*.XML, belong beside the image)");
    }
    return incidence.value_or(0) <= p_.max_incidence &&
           a.cloud_cover.value_or(0) <= p_.max_cloud_cover;
  }

  /// Index of what is wrong with a pair of which both images are fit, as text() lists it; -1:
  /// nothing.
  int fault_of(const PairFigures& f) const {
    if (f.overlap < p_.min_overlap) return 1;
    if (f.convergence && *f.convergence < p_.min_convergence) return 2;
    if (f.convergence && *f.convergence > p_.max_convergence) return 3;
    if (f.days && *f.days > p_.max_days) return 4;
    if (f.sun && *f.sun > p_.max_sun_difference) return 5;
    return -1;
  }

  static std::string text(const std::array<int, 6>& refused) {
    constexpr std::array<const char*, 6> kNames{
        "with an image above max_incidence or max_cloud_cover",
        "below min_overlap",
        "below min_convergence",
        "above max_convergence",
        "above max_days",
        "above max_sun_difference"};
    std::string all;
    for (std::size_t i = 0; i < refused.size(); ++i) {
      if (refused[i] == 0) continue;
      all += (all.empty() ? "" : ", ") + std::to_string(refused[i]) + " " + kNames[i];
    }
    return all;
  }

  static void tell(const std::string& pair, const PairFigures& f, const Context& context) {
    context.figure(pair + " overlap", f.overlap);
    if (f.convergence) context.figure(pair + " convergence_deg", *f.convergence);
    if (f.days) context.figure(pair + " days", *f.days);
    if (f.sun) context.figure(pair + " sun_deg", *f.sun);
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<ByGeometry>("by_geometry",
                           "Pairs that stand well to each other, those closest in time first.",
                           "Facciolo, de Franchis, Meinhardt-Llopis: Automatic 3D reconstruction "
                           "from multi-date satellite images, CVPRW 2017");
}
