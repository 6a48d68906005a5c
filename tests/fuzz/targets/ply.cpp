// SPDX-License-Identifier: Apache-2.0
// PLY files: points that are read, written and read again are the same points.
#include <cmath>

#include "fuzz/support/memory_file.hpp"
#include "fuzz/support/target.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/ply.hpp"

namespace xgm::fuzz {
namespace {

using Points = std::vector<std::vector<double>>;

struct Table {
  PlyHeader header;
  Points points;
};

const testing::TemporaryFolder& folder() {
  static const testing::TemporaryFolder made;
  return made;
}

Table read(const std::string& file) {
  PlyReader reader(file);
  Table table{reader.header(), {}};
  std::vector<double> values(table.header.properties.size());
  while (reader.next(values)) table.points.push_back(values);
  return table;
}

std::string write(const Table& table, const std::string& name) {
  write_ply(folder() / name, table.header, [&](const PutVertex& put) {
    for (const std::vector<double>& point : table.points) put(point);
  });
  return folder() / name;
}

/// Of text, values may be none of their type: what is written once is.
bool same(const Points& a, const Points& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < a[i].size(); ++k) {
      if (a[i][k] != b[i][k] && !(std::isnan(a[i][k]) && std::isnan(b[i][k]))) return false;
    }
  }
  return true;
}

}  // namespace

void check(std::string_view input) {
  static MemoryFile file;
  file.hold(input);
  Table table;
  if (!accepts(file.path(), [&] { table = read(file.path()); })) return;
  require(!table.header.properties.empty(), "points have properties");
  require(table.points.size() == table.header.count, "there are as many points as announced");
  require(table.points.size() <= input.size(), "no point comes from nowhere");
  const Table once = read(write(table, "once.ply"));
  require(once.header.comments == table.header.comments, "comments are kept");
  require(once.points.size() == table.points.size(), "points are kept");
  const Table twice = read(write(once, "twice.ply"));
  require(same(once.points, twice.points), "points that are written are read as they were");
}

std::vector<std::string> seeds() {
  const Table table{{{"crs EPSG:32740", "projection: UTM 40S"},
                     {{"x", PlyType::float64}, {"red", PlyType::uint8}, {"pair", PlyType::uint16}},
                     2},
                    {{359922.4, 7, 0}, {360104.6, 255, 65535}}};
  return {read_file(write(table, "seed.ply")),
          "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty int n\n"
          "element face 1\nproperty list uchar int vertex_indices\nend_header\n1.5 -2\nnan 3\n"};
}

std::vector<std::string> words() {
  return {"ply\n",         "format ",
          "ascii",         "binary_little_endian",
          " 1.0\n",        "element vertex",
          "element ",      "property ",
          "list ",         "float",
          "double",        "uchar",
          "ushort",        "int",
          "comment ",      "obj_info ",
          "\nend_header\n"};
}

}  // namespace xgm::fuzz
