// SPDX-License-Identifier: Apache-2.0
// The tables of a race.
#include <algorithm>

#include "xgm/base/text.hpp"
#include "xgm/evaluation/speed.hpp"

namespace xgm {
namespace {

using Row = std::vector<std::string>;

/// Columns are as wide as their widest cell; the first `names` stand left, figures right.
std::string table(std::size_t names, const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 3);
  for (const Row& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string out;
  const auto line = [&](auto cell_at) {
    for (std::size_t c = 0; c < widths.size(); ++c) out += "| " + cell_at(c) + ' ';
    out += "|\n";
  };
  const auto line_of = [&](const Row& row) {
    line([&](std::size_t c) {
      const std::string padding(widths[c] - row[c].size(), ' ');
      return c < names ? row[c] + padding : padding + row[c];
    });
  };
  line_of(rows.front());
  line([&](std::size_t c) {
    return c < names ? std::string(widths[c], '-') : std::string(widths[c] - 1, '-') + ':';
  });
  std::for_each(rows.begin() + 1, rows.end(), line_of);
  return out;
}

double seconds_of(const SpeedTimes& times) { return median(times.seconds); }

/// "x HH": so many times as fast as OpenCV's mode.
std::string ratio(const SpeedTimes& peer, const SpeedTimes& times) {
  const bool known = !peer.seconds.empty() && !times.seconds.empty();
  return known ? fixed_number(seconds_of(peer) / seconds_of(times), 2) : "-";
}

bool is_peer(const SpeedTimes& times) { return times.simd.empty(); }

std::string title(const SpeedResult& result) {
  const int threads = result.race.threads, rounds = result.race.rounds;
  const auto counted = [](int count, const std::string& what) {
    return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
  };
  return std::to_string(result.size.width) + " x " + std::to_string(result.size.height) + " px, " +
         std::to_string(result.disparities.size()) + " disparities, " + counted(threads, "thread") +
         ", medians of " + counted(rounds, "round") + "\n";
}

std::string contestants(const SpeedResult& result) {
  std::vector<const SpeedTimes*> peers;
  Row header{"pipeline", "SIMD", "s", "least s", "CPU s", "MDE/s"};
  for (const SpeedTimes& times : result.times) {
    if (!is_peer(times)) continue;
    peers.push_back(&times);
    header.push_back("x " + times.name.substr(times.name.find(' ') + 1));
  }
  std::vector<Row> rows{header};
  const double evaluations =
      static_cast<double>(result.size.area()) * result.disparities.size() / 1e6;
  for (const SpeedTimes& times : result.times) {
    Row row{times.name, is_peer(times) ? "its own" : times.simd};
    if (times.seconds.empty()) {
      row.insert(row.end(), 4, "-");
    } else {
      row.push_back(fixed_number(seconds_of(times), 3));
      row.push_back(fixed_number(*std::min_element(times.seconds.begin(), times.seconds.end()), 3));
      row.push_back(fixed_number(median(times.cpu_seconds), 3));
      row.push_back(fixed_number(evaluations / seconds_of(times), 0));
    }
    for (const SpeedTimes* peer : peers) row.push_back(ratio(*peer, times));
    rows.push_back(std::move(row));
  }
  return table(2, rows);
}

std::string stages(const SpeedTimes& times) {
  double sum = 0;
  for (const StageSeconds& stage : times.stages) sum += median(stage.seconds);
  std::vector<Row> rows{{"stages of " + times.name + " (" + times.simd + ")", "s", "%"}};
  for (const StageSeconds& stage : times.stages) {
    const double seconds = median(stage.seconds);
    rows.push_back({stage.stage, fixed_number(seconds, 3), fixed_number(100 * seconds / sum, 1)});
  }
  return table(1, rows);
}

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

std::string speed_markdown(const SpeedResult& result) {
  std::string out = title(result) + '\n' + contestants(result);
  for (const SpeedTimes& times : result.times) {
    if (!times.failure.empty()) out += times.name + " was not timed: " + times.failure + '\n';
  }
  for (const SpeedTimes& times : result.times) {
    if (!times.stages.empty()) out += '\n' + stages(times);
  }
  return out;
}

}  // namespace xgm
