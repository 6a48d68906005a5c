// SPDX-License-Identifier: Apache-2.0
#include "io/ply_values.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace xgm {
namespace {

struct TypeNames {
  std::string_view first;   ///< of the original format
  std::string_view second;  ///< that says the size
  std::size_t bytes;
};

constexpr std::array<TypeNames, 8> kTypes{{{"char", "int8", 1},
                                           {"uchar", "uint8", 1},
                                           {"short", "int16", 2},
                                           {"ushort", "uint16", 2},
                                           {"int", "int32", 4},
                                           {"uint", "uint32", 4},
                                           {"float", "float32", 4},
                                           {"double", "float64", 8}}};

const TypeNames& names(PlyType type) { return kTypes[static_cast<std::size_t>(type)]; }

template <class Whole>
std::uint64_t rounded(double value) {
  if (std::isnan(value)) return 0;
  const double least = std::numeric_limits<Whole>::min(), most = std::numeric_limits<Whole>::max();
  return static_cast<std::uint64_t>(
      static_cast<Whole>(std::clamp(std::nearbyint(value), least, most)));
}

std::uint64_t bits_of(PlyType type, double value) {
  switch (type) {
    case PlyType::int8:
      return rounded<std::int8_t>(value);
    case PlyType::uint8:
      return rounded<std::uint8_t>(value);
    case PlyType::int16:
      return rounded<std::int16_t>(value);
    case PlyType::uint16:
      return rounded<std::uint16_t>(value);
    case PlyType::int32:
      return rounded<std::int32_t>(value);
    case PlyType::uint32:
      return rounded<std::uint32_t>(value);
    case PlyType::float32:
      return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    case PlyType::float64:
      break;
  }
  return std::bit_cast<std::uint64_t>(value);
}

}  // namespace

std::size_t size_of(PlyType type) { return names(type).bytes; }

std::string_view name_of(PlyType type) { return names(type).first; }

std::optional<PlyType> ply_type(std::string_view name) {
  for (std::size_t i = 0; i < kTypes.size(); ++i) {
    if (name == kTypes[i].first || name == kTypes[i].second) return static_cast<PlyType>(i);
  }
  return std::nullopt;
}

double load(const char* bytes, PlyType type) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size_of(type); ++i) {
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  }
  switch (type) {
    case PlyType::int8:
      return static_cast<std::int8_t>(bits);
    case PlyType::int16:
      return static_cast<std::int16_t>(bits);
    case PlyType::int32:
      return static_cast<std::int32_t>(bits);
    case PlyType::uint8:
    case PlyType::uint16:
    case PlyType::uint32:
      return static_cast<double>(bits);
    case PlyType::float32:
      return double{std::bit_cast<float>(static_cast<std::uint32_t>(bits))};
    case PlyType::float64:
      break;
  }
  return std::bit_cast<double>(bits);
}

void store(char* bytes, PlyType type, double value) {
  const std::uint64_t bits = bits_of(type, value);
  for (std::size_t i = 0; i < size_of(type); ++i) {
    bytes[i] = static_cast<char>(bits >> (8 * i) & 0xFFU);
  }
}

}  // namespace xgm
