// SPDX-License-Identifier: Apache-2.0
// What both bench programs do first: obey XGM_SIMD, and say on what they run.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <iostream>

#include "bench/bench.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/simd.hpp"

int main(int argc, char** argv) {
  try {
    const char* const target_wanted = std::getenv("XGM_SIMD");
    const xgm::SimdChoice simd(target_wanted != nullptr ? target_wanted : "");
    std::string targets;
    for (const std::string& target : xgm::simd_targets()) targets += ' ' + target;
    benchmark::AddCustomContext("SIMD targets of this processor", targets);
    benchmark::AddCustomContext("SIMD target of the library's kernels", xgm::simd_target());
    xgm::bench::register_all();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
  } catch (const xgm::Error& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}
