// SPDX-License-Identifier: Apache-2.0
// The heights of a cell in groups, of which one is taken: where pairs disagree because they saw a
// tree with and without leaves, or a roof and the street beside it, the median may be a height that
// none of them saw. Facciolo, de Franchis, Meinhardt-Llopis: Automatic 3D reconstruction from
// multi-date satellite images (CVPRW 2017) keep the lowest of the clusters of k-medians. Here k
// grows until the clusters are precise, and small clusters, which are mismatches, may be passed
// over.
#include <algorithm>
#include <cmath>

#include "plugins/fusion/cell_fusion/fuse_cells.hpp"
#include "plugins/fusion/k_medians/clusters.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

enum class Choice { lowest, highest, largest };

class KMedians final : public Fusion {
 public:
  struct Parameters {
    CellFusion cells;
    int k = 8;
    double precision = 1;
    double min_share = 0.2;
    Choice choice = Choice::lowest;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    geo::describe(p.cells, set);
    set.add("k", p.k, "Most clusters of a cell. So few are made that all heights are precise.")
        .range(1, 100);
    set.add("precision", p.precision,
            "Heights of a cluster are no farther from its median, as long as k allows it.")
        .unit("m")
        .range(0.001, 1000);
    set.add("min_share", p.min_share,
            "Clusters with a smaller share of the cell's heights are passed over, unless all are "
            "smaller: then the largest is taken.")
        .range(0, 1);
    set.add_choice(
        "choice", p.choice, "Which of the clusters is taken.",
        {{"lowest", Choice::lowest}, {"highest", Choice::highest}, {"largest", Choice::largest}});
  }

  explicit KMedians(Parameters parameters) : p_(parameters) {}

  FusedSurface run(const std::vector<Raster>& surfaces, const Context& context) const override {
    return fuse_cells(
        surfaces, p_.cells, [&](std::vector<float>& heights) { return height_of(heights); },
        context);
  }

 private:
  float height_of(std::vector<float>& heights) const {
    std::ranges::sort(heights);
    std::vector<Cluster> clusters;
    for (int k = 1; k <= p_.k; ++k) {
      clusters = k_medians(heights, static_cast<std::size_t>(k));
      if (std::ranges::all_of(clusters, [&](const Cluster& c) { return is_precise(heights, c); })) {
        break;
      }
    }
    return median_of(heights, chosen(clusters, heights.size()));
  }

  bool is_precise(const std::vector<float>& sorted, const Cluster& cluster) const {
    const double middle = double{median_of(sorted, cluster)};
    return middle - double{sorted[cluster.begin]} <= p_.precision &&
           double{sorted[cluster.end - 1]} - middle <= p_.precision;
  }

  Cluster chosen(std::vector<Cluster> clusters, std::size_t heights) const {
    const Cluster largest = *std::ranges::max_element(clusters, {}, &Cluster::size);
    const double least = p_.min_share * static_cast<double>(heights);
    std::erase_if(clusters,
                  [&](const Cluster& c) { return static_cast<double>(c.size()) < least; });
    if (clusters.empty() || p_.choice == Choice::largest) return largest;
    return p_.choice == Choice::lowest ? clusters.front() : clusters.back();
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<KMedians>("k_medians",
                         "The heights of each cell in clusters, one of which is taken.",
                         "Facciolo, de Franchis, Meinhardt-Llopis: Automatic 3D reconstruction "
                         "from multi-date satellite images, CVPRW 2017");
}
