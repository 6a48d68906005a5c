// SPDX-License-Identifier: Apache-2.0
// What libFuzzer calls. With --write-seeds=FOLDER a target writes its first inputs there, and its
// dictionary to FOLDER.dict, and does nothing else.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "fuzz/support/target.hpp"
#include "xgm/io/file.hpp"

namespace xgm::fuzz {
namespace {

/// "\x2e" for a full stop: the form in which a dictionary may hold any byte.
std::string dictionary_line(const std::string& word) {
  std::string line = "\"";
  for (const char byte : word) {
    std::array<char, 5> escaped{};
    std::snprintf(escaped.data(), escaped.size(), "\\x%02x",
                  static_cast<unsigned>(static_cast<unsigned char>(byte)));
    line += escaped.data();
  }
  return line + "\"\n";
}

void write_seeds(const std::string& folder) {
  std::filesystem::create_directories(folder);
  std::size_t number = 0;
  for (const std::string& seed : seeds()) {
    write_file(folder + "/seed_" + std::to_string(number++), seed);
  }
  std::string dictionary;
  for (const std::string& word : words()) dictionary += dictionary_line(word);
  write_file(folder + ".dict", dictionary);
}

}  // namespace

void require(bool holds, const char* claim) {
  if (holds) return;
  std::fprintf(stderr, "This does not hold: %s\n", claim);
  std::abort();
}

const Registry& builtins() {
  static const Registry registry = Registry::with_builtins();
  return registry;
}

}  // namespace xgm::fuzz

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  const std::string_view option = "--write-seeds=";
  for (int i = 1; i < *count; ++i) {
    const std::string_view argument = (*arguments)[i];
    if (!argument.starts_with(option)) continue;
    xgm::fuzz::write_seeds(std::string(argument.substr(option.size())));
    std::exit(EXIT_SUCCESS);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  xgm::fuzz::check({reinterpret_cast<const char*>(bytes), size});
  return 0;
}
