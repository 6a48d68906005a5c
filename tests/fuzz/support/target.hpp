// SPDX-License-Identifier: Apache-2.0
// A fuzz target: one file in targets/, which defines check(), seeds() and words(). main.cpp hands
// them to libFuzzer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "xgm/base/error.hpp"
#include "xgm/plugin/registry.hpp"

namespace xgm::fuzz {

/// Reads `input`, which may be anything, and requires what must hold then. An exception that leaves
/// it is a find, too.
void check(std::string_view input);

/// Inputs to begin with: right ones, each of another form.
std::vector<std::string> seeds();

/// What the format is made of, for the fuzzer to put in.
std::vector<std::string> words();

/// Ends the program, which is a find, unless `holds`.
void require(bool holds, const char* claim);

/// The library's own plugins.
const Registry& builtins();

/// Whether `read` accepts what it reads. If not, its Error must name `place`.
template <class Read>
bool accepts(const std::string& place, Read read) {
  try {
    read();
  } catch (const Error& error) {
    require(std::string_view(error.what()).find(place) != std::string_view::npos,
            "an error names the place of the mistake");
    return false;
  }
  return true;
}

}  // namespace xgm::fuzz
