// SPDX-License-Identifier: Apache-2.0
#include <ostream>

#include "io/ply_values.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/ply.hpp"

namespace xgm {
namespace {

std::string text_of(const PlyHeader& header) {
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : header.comments) text += "comment " + comment + "\n";
  text += "element vertex " + std::to_string(header.count) + "\n";
  for (const PlyProperty& property : header.properties) {
    text += "property " + std::string(name_of(property.type)) + " " + property.name + "\n";
  }
  return text + "end_header\n";
}

}  // namespace

void write_ply(const std::string& file, const PlyHeader& header,
               const std::function<void(const PutVertex& put)>& vertices) {
  write_file(file, [&](std::ostream& stream) {
    stream << text_of(header);
    std::string record;
    std::uint64_t written = 0;
    vertices([&](std::span<const double> values) {
      record.clear();
      for (std::size_t i = 0; i < header.properties.size(); ++i) {
        const PlyType type = header.properties[i].type;
        record.resize(record.size() + size_of(type));
        store(record.data() + record.size() - size_of(type), type, values[i]);
      }
      stream.write(record.data(), static_cast<std::streamsize>(record.size()));
      ++written;
    });
    if (written != header.count) {
      throw Error(file + ": " + std::to_string(header.count) + " points were announced, but " +
                  std::to_string(written) + " written");
    }
  });
}

}  // namespace xgm
