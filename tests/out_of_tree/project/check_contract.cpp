// SPDX-License-Identifier: Apache-2.0
// Does a stage keep the contract of its kind?  check_contract PLUGIN_FILE KIND YAML
#include <iostream>
#include <xgm/base/error.hpp>
#include <xgm/pipeline.hpp>
#include <xgm/testing/contract.hpp>

int main(int argc, char** argv) try {
  if (argc != 4) throw xgm::Error("usage: check_contract PLUGIN_FILE KIND YAML");
  xgm::Registry registry = xgm::Registry::with_builtins();
  if (!registry.load(argv[1])) throw xgm::Error(registry.failures().front().reason);
  const auto stage = xgm::make_stage(argv[2], argv[3], registry);
  const xgm::testing::Violations violations = xgm::testing::check_stage(*stage);
  for (const std::string& violation : violations) std::cout << violation << '\n';
  return violations.empty() ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
