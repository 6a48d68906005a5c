// SPDX-License-Identifier: Apache-2.0
#include "xgm/pipeline/health.hpp"

#include <cstdlib>
#include <filesystem>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/version.hpp>
#include <thread>

#include "xgm/base/error.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/base/simd.hpp"
#include "xgm/base/suggest.hpp"
#include "xgm/base/text.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/pipeline/installation.hpp"
#include "xgm/plugin/handshake.hpp"
#include "xgm/plugin/version.hpp"

namespace xgm {
namespace {

namespace fs = std::filesystem;

Finding version() {
  return {.topic = "version",
          .text = "xgm " XGM_VERSION " (" XGM_BUILD_TAG "), " + library_file(),
          .facts = {{"xgm", XGM_VERSION}, {"build", XGM_BUILD_TAG}, {"library", library_file()}}};
}

/// OpenCV keeps its binary interface within a minor version.
Finding opencv() {
  const std::string built = CV_VERSION, loaded = cv::getVersionString();
  const auto minor = [](const std::string& text) { return text.substr(0, text.rfind('.')); };
  Finding finding{.topic = "opencv",
                  .text = "OpenCV " + loaded,
                  .facts = {{"built_with", built}, {"loaded", loaded}}};
  if (minor(built) != minor(loaded)) {
    finding.health = Health::broken;
    finding.text += " is loaded, but xgm was built with " + built + "; build xgm again";
  }
  return finding;
}

Finding processor() {
  const unsigned cores = std::thread::hardware_concurrency();
  const std::vector<std::string> targets = simd_targets();
  return {.topic = "processor",
          .text = std::to_string(cores) + (cores == 1 ? " core" : " cores") + "; SIMD target " +
                  simd_target() + ", of " + join(targets),
          .facts = {{"cores", cores}, {"simd", simd_target()}, {"simd_targets", targets}}};
}

/// What the environment says to OpenMP and to xgm.
Finding threads() {
  Finding finding{.topic = "threads",
                  .text = std::to_string(thread_count()) +
                          " for each run, unless --threads says "
                          "otherwise",
                  .facts = {{"threads", thread_count()}}};
  Json settings = Json::object();
  for (const char* name : {"OMP_NUM_THREADS", "OMP_THREAD_LIMIT", "OMP_DYNAMIC", "OMP_PROC_BIND",
                           "OMP_PLACES", "GOMP_CPU_AFFINITY", "XGM_SIMD"}) {
    const char* const value = std::getenv(name);
    if (value == nullptr) continue;
    settings[name] = value;
    finding.text += std::string("; ") + name + "=" + value;
  }
  finding.facts["environment"] = settings;
  return finding;
}

Finding memory() {
  const auto bytes = static_cast<double>(available_memory());
  if (available_memory() == UINT64_MAX) {
    return {.topic = "memory", .text = "the system does not say how much there is"};
  }
  return {.topic = "memory",
          .text = bytes_text(bytes) + " can be taken; pipeline plan says what a run needs",
          .facts = {{"available_bytes", available_memory()}}};
}

Finding temporary_folder() {
  Finding finding{.topic = "temporary files"};
  std::error_code unusable;
  const fs::path folder = fs::temp_directory_path(unusable);
  try {
    if (unusable) throw Error("TMPDIR names no folder; correct it, or unset it");
    require_writable(folder.string());
    const fs::space_info space = fs::space(folder);
    finding.text =
        folder.string() + ", " + bytes_text(static_cast<double>(space.available)) + " are free";
    finding.facts = {{"folder", folder.string()}, {"available_bytes", space.available}};
  } catch (const std::exception& error) {
    finding.health = Health::broken;
    finding.text = error.what();
  }
  return finding;
}

}  // namespace

const char* to_string(Health health) {
  switch (health) {
    case Health::good:
      return "good";
    case Health::missing:
      return "missing";
    case Health::broken:
      return "broken";
  }
  return "";
}

std::vector<Finding> examine_machine() {
  return {version(), opencv(), processor(), threads(), memory(), temporary_folder()};
}

}  // namespace xgm
