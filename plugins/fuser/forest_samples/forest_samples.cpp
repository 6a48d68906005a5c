// SPDX-License-Identifier: Apache-2.0
// What forests are trained on.
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "plugins/fuser/candidate_choice/choice.hpp"
#include "plugins/fuser/candidate_features/features.hpp"
#include "xgm/plugin.hpp"

namespace {

namespace fuser = xgm::fuser;

/// Stands in the place of the fuser `forest` while samples are collected: it computes the features
/// that the forest would see, by the same code, and writes them.
class ForestSamples final : public xgm::Fuser {
 public:
  struct Parameters {
    std::string file;
    xgm::SlotList<xgm::Cost> costs;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("file", p.file,
            "Where the samples go, replaced if it is there; \"\" writes none. An array of numpy "
            "(.npy) with a record for each pixel whose candidates differ: row, column, their "
            "disparities (NaN: none), and the bytes of the features.");
    set.add("costs", p.costs, "Those of the forest that will be trained.");
  }
  explicit ForestSamples(Parameters p) : p_(std::move(p)) {}

  xgm::DisparityMap run(const xgm::Candidates& candidates, const xgm::ImagePair& pair,
                        const xgm::Context& context) const override {
    const fuser::CandidateMaps maps(candidates, pair, p_.costs, context);
    if (!p_.file.empty()) write(maps);
    return fuser::chosen(
        candidates, [&](int y, int x) { return fuser::first_with_disparity(candidates, y, x); });
  }

 private:
  void write(const fuser::CandidateMaps& maps) const {
    const fuser::FeatureLayout layout{maps.matchers(), maps.costs_per_matcher};
    const cv::Size size = maps.pair.size();
    std::vector<std::string> rows(static_cast<std::size_t>(size.height));
    xgm::parallel_for(0, size.height, [&](int y) {
      for (int x = 0; x < size.width; ++x) {
        if (maps.disputed(y, x)) append(maps, layout, y, x, rows[static_cast<std::size_t>(y)]);
      }
    });
    std::size_t bytes = 0;
    for (const std::string& row : rows) bytes += row.size();
    std::ofstream file(p_.file, std::ios::binary);
    file << header(layout, bytes / record_size(layout));
    for (const std::string& row : rows) file << row;
    file.close();
    if (!file) throw xgm::Error(p_.file + ": cannot be written; choose another file");
  }

  static std::size_t record_size(const fuser::FeatureLayout& layout) {
    return 8 + 4 * static_cast<std::size_t>(layout.matchers) +
           static_cast<std::size_t>(layout.count());
  }

  template <class Number>
  static void put(Number number, std::string& to) {
    const auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    to.append(bytes.data(), bytes.size());
  }

  static void append(const fuser::CandidateMaps& maps, const fuser::FeatureLayout& layout, int y,
                     int x, std::string& to) {
    put(y, to);
    put(x, to);
    for (const xgm::DisparityMap& map : maps.candidates.maps) put(map.disparity(y, x), to);
    std::vector<std::uint8_t> features(static_cast<std::size_t>(layout.count()));
    fuser::features_at(maps, y, x, features.data());
    to.append(features.begin(), features.end());
  }

  /// As the format wants it: magic, version 2, length, a Python literal padded to 64 bytes.
  static std::string header(const fuser::FeatureLayout& layout, std::size_t records) {
    std::string names;
    for (const std::string& name : layout.names()) names += "('" + name + "', '|u1'), ";
    std::string text = "{'descr': [('row', '<i4'), ('column', '<i4'), ('disparities', '<f4', (" +
                       std::to_string(layout.matchers) + ",)), " + names +
                       "], 'fortran_order': False, 'shape': (" + std::to_string(records) + ",), }";
    constexpr std::size_t kPrefix = 12;
    text.append(63 - (kPrefix + text.size()) % 64, ' ');
    text += '\n';
    std::string all("\x93NUMPY\x02\x00", 8);
    put(static_cast<std::uint32_t>(text.size()), all);
    return all + text;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<ForestSamples>("forest_samples",
                              "Writes what a forest is trained on, and takes the first disparity.");
}
