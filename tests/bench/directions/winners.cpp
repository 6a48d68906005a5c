// SPDX-License-Identifier: Apache-2.0
// The winner of each path direction of SGM-8 at each pixel, and what it costs along all of them:
// what a selection could choose from beside the winner of the sums.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "bench/directions/path_costs.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/scene.hpp"
#include "xgm/pipeline.hpp"
#include "xgm/plugin.hpp"

namespace {

using namespace xgm;

constexpr std::size_t kDirections = 8;
constexpr std::size_t kCandidates = kDirections + 1;  // the winner of the sums comes first
constexpr std::int16_t kNone = -32768;

/// Axes and diagonals: four directions, then their opposites.
constexpr std::array<Direction, kDirections> kAll{
    {{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {-1, 0}, {0, -1}, {-1, -1}, {1, -1}}};

/// A record of the array, with the fields that kFields names.
struct Record {
  std::int16_t disparities[kCandidates];
  std::uint16_t sums[kCandidates];                ///< less the lowest of the pixel
  std::uint16_t paths[kCandidates][kDirections];  ///< likewise, of each direction
  std::uint16_t costs[kCandidates];
};
constexpr const char* kFields =
    "[('disparities', '<i2', (9,)), ('sums', '<u2', (9,)), ('paths', '<u2', (9, 8)), "
    "('costs', '<u2', (9,))]";
static_assert(sizeof(Record) == 2 * (3 * kCandidates + kCandidates * kDirections));
static_assert(std::endian::native == std::endian::little);

struct Aggregated {
  CostVolume costs;
  AggregatedVolume sums;
  std::vector<Volume<std::uint16_t>> paths;
};

Aggregated aggregate(const ImagePair& pair, Interval range, const std::string& penalty) {
  const Registry registry = Registry::with_builtins();
  const Context context;
  const auto field = make_stage<Penalty>(penalty, registry)->run(pair, context);
  const auto shape = std::make_shared<const VolumeShape>(
      DisparityRange::uniform(pair.size(), range), pair.base.valid);
  CostVolume costs =
      make_stage<Cost>("{type: census, window: 5}", registry)->run(pair, shape, context);
  AggregatedVolume sums =
      make_stage<Aggregation>("{type: sgm, directions: 8}", registry)->run(costs, *field, context);
  std::vector<Volume<std::uint16_t>> paths;
  for (const Direction r : kAll) paths.push_back(directions::path_costs(costs, *field, r));
  directions::require_sum(paths, costs, sums);
  return {std::move(costs), std::move(sums), std::move(paths)};
}

Record record_of(const Aggregated& all, int y, int x) {
  Record record{};
  std::fill_n(record.disparities, kCandidates, kNone);
  const auto sums = all.sums.cells(y, x);
  const auto best = std::min_element(sums.begin(), sums.end());
  if (best == sums.end() || *best == AggregatedVolume::kNoMatch) return record;
  std::array<std::size_t, kCandidates> cells{static_cast<std::size_t>(best - sums.begin())};
  std::array<int, kDirections> lowest{};
  for (std::size_t r = 0; r < kDirections; ++r) {
    const auto path = all.paths[r].cells(y, x);
    cells[r + 1] = static_cast<std::size_t>(std::ranges::min_element(path) - path.begin());
    lowest[r] = path[cells[r + 1]];
  }
  for (std::size_t c = 0; c < kCandidates; ++c) {
    const std::size_t cell = cells[c];
    const int begin = all.sums.shape().begin(y, x);
    record.disparities[c] = static_cast<std::int16_t>(begin + static_cast<int>(cell));
    record.sums[c] = static_cast<std::uint16_t>(sums[cell] - *best);
    record.costs[c] = all.costs.cells(y, x)[cell];
    for (std::size_t r = 0; r < kDirections; ++r) {
      record.paths[c][r] = static_cast<std::uint16_t>(all.paths[r].cells(y, x)[cell] - lowest[r]);
    }
  }
  return record;
}

/// An array of numpy, version 1: magic, length of the header, a Python literal padded to 64 bytes.
std::string npy_of(const std::vector<Record>& records, cv::Size size) {
  std::string header = std::string("{'descr': ") + kFields +
                       ", 'fortran_order': False, 'shape': (" + std::to_string(size.height) + ", " +
                       std::to_string(size.width) + "), }";
  constexpr std::size_t kPrefix = 10;
  header.append(63 - (kPrefix + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() % 256);
  bytes += static_cast<char>(header.size() / 256);
  bytes += header;
  return bytes.append(reinterpret_cast<const char*>(records.data()),
                      records.size() * sizeof(Record));
}

void write_winners(const ImagePair& pair, Interval range, const std::string& penalty,
                   const std::filesystem::path& file) {
  const Aggregated all = aggregate(pair, range, penalty);
  std::vector<Record> records;
  for (int y = 0; y < pair.size().height; ++y) {
    for (int x = 0; x < pair.size().width; ++x) records.push_back(record_of(all, y, x));
  }
  write_file(file.string(), npy_of(records, pair.size()));
}

int run(const std::string& folder, const std::string& penalty,
        const std::filesystem::path& output) {
  const Scene scene = load_scene(find_scene(folder, Registry::with_builtins()));
  if (!scene.disparities) throw Error(folder + ": the disparities to search are not known");
  const Interval range = *scene.disparities;
  std::filesystem::create_directories(output);
  write_winners(scene.pair, range, penalty, output / "left.npy");
  write_winners(scene.pair.swapped(), {1 - range.end, 1 - range.begin}, penalty,
                output / "right.npy");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr
        << "usage: xgm_bench_winners SCENE_DIR PENALTY OUTPUT_DIR\n"
           "Writes left.npy and right.npy: for each pixel the winner of the sums of SGM-8 and "
           "of each direction, and what these cost. PENALTY is the YAML of a stage.\n";
    return 2;
  }
  try {
    return run(argv[1], argv[2], argv[3]);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}
