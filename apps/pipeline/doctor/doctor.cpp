// SPDX-License-Identifier: Apache-2.0
// pipeline doctor: what is there, and what does not work?
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "doctor/python_package.hpp"
#include "options/pipelines.hpp"
#include "xgm/pipeline/health.hpp"

namespace xgm::cli {
namespace {

struct Options {
  bool json = false;
  PluginOptions plugins;
};

Finding satellites(const Registry& with_satellites, const Registry& without) {
  Finding finding{.topic = "satellites", .text = "built in, with GDAL and PROJ"};
  if (with_satellites.failures().size() > without.failures().size()) {
    finding.health = Health::missing;
    finding.text = with_satellites.failures().back().reason;
  }
  return finding;
}

std::vector<Finding> examine(const Options& options) {
  std::vector<Finding> findings = examine_machine();
  const auto add = [&](const std::vector<Finding>& more) {
    findings.insert(findings.end(), more.begin(), more.end());
  };
  const Registry plugins = load_plugins(options.plugins);
  add(examine_plugins(plugins));
  Registry all = plugins;
  add_satellites(all);
  add({satellites(all, plugins), python_package()});
  add(examine_pipelines(all));
  return findings;
}

void print_text(const std::vector<Finding>& findings, std::ptrdiff_t broken) {
  constexpr int kHealth = 9, kTopic = 17;
  for (const Finding& finding : findings) {
    std::cout << std::left << std::setw(kHealth) << to_string(finding.health) << std::setw(kTopic)
              << finding.topic << finding.text << '\n';
  }
  if (broken == 0) std::cout << "nothing is broken\n";
  if (broken > 0) std::cout << "broken: " << broken << " of " << findings.size() << " findings\n";
}

void print_json(const std::vector<Finding>& findings, std::ptrdiff_t broken) {
  Json list = Json::array();
  for (const Finding& finding : findings) {
    list.push_back({{"topic", finding.topic},
                    {"health", to_string(finding.health)},
                    {"text", finding.text},
                    {"facts", finding.facts}});
  }
  std::cout << Json{{"sound", broken == 0}, {"findings", list}}.dump(2) << '\n';
}

int doctor(const Options& options) {
  const std::vector<Finding> findings = examine(options);
  const auto broken = std::ranges::count(findings, Health::broken, &Finding::health);
  options.json ? print_json(findings, broken) : print_text(findings, broken);
  return broken == 0 ? kOk : kFailed;
}

}  // namespace

void add_doctor(CommandLine& line) {
  auto options = std::make_shared<Options>();
  Command command =
      line.add("doctor", "Say what the program finds on this machine, and what does not work",
               [options] { return doctor(*options); });
  command.flag("--json", options->json, "For programs");
  command.footer("Exit codes: 0 nothing is broken; 1 something is.");
  add_plugin_options(command, options->plugins);
}

}  // namespace xgm::cli
