// SPDX-License-Identifier: Apache-2.0
// my_plugin keeps the contract of its kind, which other stages rely on. Argument: the plugin file.
#include <iostream>
#include <xgm/pipeline.hpp>
#include <xgm/testing/contract.hpp>

int main(int, char** arguments) {
  try {
    xgm::Registry registry = xgm::Registry::with_builtins();
    if (!registry.load(arguments[1])) throw xgm::Error(registry.failures().front().reason);
    const auto stage = xgm::make_stage("my_kind", "my_plugin", registry);
    const xgm::testing::Violations violations = xgm::testing::check_stage(*stage);
    for (const std::string& violation : violations) std::cout << violation << '\n';
    return violations.empty() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cout << error.what() << '\n';
    return 1;
  }
}
