// SPDX-License-Identifier: Apache-2.0
// The pipeline that a report shows is the pipeline that ran.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "framework/report/page.hpp"
#include "support/paths.hpp"
#include "support/support.hpp"
#include "xgm/pipeline/pipeline.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

std::string unescaped(std::string text) {
  for (const auto& [from, to] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}}) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; ++at) {
      text.replace(at, std::string(from).size(), to);
    }
  }
  return text;
}

}  // namespace

TEST_CASE("report: the YAML shown of each shipped pipeline resolves to the same pipeline") {
  const Registry registry = Registry::with_builtins();
  const std::filesystem::path folder = std::filesystem::path(XGM_SOURCE_DIR) / "pipelines";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    CAPTURE(entry.path().string());
    const LoadedPipeline shipped = load_pipeline(entry.path().string(), registry);
    REQUIRE(shipped.pipeline);
    const auto resolved = nlohmann::json::parse(shipped.pipeline->resolved_json());
    ReportScene scene = random_scene({4, 4}, 0, 2, 1);
    scene.runs[0].record_json = nlohmann::json{{"pipeline", {{"resolved", resolved}}}}.dump();
    const std::string html = report_html({"t", "", {scene}});
    const std::size_t begin = html.find("</p><pre>") + 9;
    const std::string yaml = unescaped(html.substr(begin, html.find("</pre>", begin) - begin));
    const LoadedPipeline again = load_pipeline_text(yaml, "shown", registry);
    for (const Diagnostic& fault : again.diagnostics) FAIL_CHECK(to_string(fault));
    REQUIRE(again.pipeline);
    CHECK(nlohmann::json::parse(again.pipeline->resolved_json()) == resolved);
  }
}
