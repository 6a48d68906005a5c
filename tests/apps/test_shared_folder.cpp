// SPDX-License-Identifier: Apache-2.0
// What an output folder holds is of one run, however many write to it and however they end.
// XGM_STRESS_ROUNDS and XGM_STRESS_MOMENTS make the searches longer.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "apps/small_scene.hpp"
#include "support/paths.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::SmallScene;

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

int count_from(const char* variable, int usual) {
  const char* const text = std::getenv(variable);
  return text != nullptr ? std::atoi(text) : usual;
}

const std::set<std::string> kKnownNames{"disparity.pfm", "disparity.png", "report.html",
                                        "run.json",      "status.png",    "unfinished.json"};

/// Runs that differ in a parameter, and so in their maps.
struct Runs : SmallScene {
  Runs() : SmallScene({120, 60}) {
    for (const int window : {3, 5, 7, 9}) {
      const std::string folder = "alone" + std::to_string(window);
      const auto begin = Clock::now();
      REQUIRE(call(arguments(window, folder)).exit_code == 0);
      duration = std::max(duration, Clock::now() - begin);
      maps[window] = read_file(*this / (folder + "/disparity.pfm"));
    }
  }
  static std::string arguments(int window, const std::string& folder) {
    return "run p.yaml scene --threads 1 --report --output " + folder +
           " --set matcher.cost.window=" + std::to_string(window);
  }
  /// If there is a record, it tells of the map that lies beside it; and all names are known.
  void check_unmixed() const {
    for (const auto& entry : fs::directory_iterator(*this / "out")) {
      CAPTURE(entry.path());
      CHECK(kKnownNames.contains(entry.path().filename().string()));
    }
    if (!fs::exists(*this / "out/run.json")) return;
    const auto record = nlohmann::json::parse(read_file(*this / "out/run.json"));
    const int window = record["pipeline"]["resolved"]["matcher"]["cost"]["window"];
    CHECK(read_file(*this / "out/disparity.pfm") == maps.at(window));
    for (const auto& file : record["outputs"]) {
      CHECK(fs::file_size(*this / ("out/" + file["file"].get<std::string>())) == file["bytes"]);
    }
  }

  std::map<int, std::string> maps;
  Clock::duration duration{};
};

/// Begins a run that nobody waits for.
pid_t begin(const Runs& runs, int window) {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child > 0) return child;
  const int nothing = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nothing, stream);
  const bool moved = ::chdir(runs.path().c_str()) == 0;
  const std::string command = "exec " XGM_PIPELINE_BINARY " " + Runs::arguments(window, "out");
  if (moved) ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
  ::_exit(127);
}

/// The exit code, or 128 + the signal.
int end_of(pid_t child) {
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

TEST_CASE("runs that share a folder: one writes, and the others are refused") {
  const Runs runs;
  for (int round = count_from("XGM_STRESS_ROUNDS", 4); round > 0; --round) {
    CAPTURE(round);
    fs::remove_all(runs / "out");
    std::vector<pid_t> children;
    for (const auto& [window, map] : runs.maps) children.push_back(begin(runs, window));
    int written = 0;
    for (const pid_t child : children) {
      const int code = end_of(child);
      CHECK((code == 0 || code == 2));
      written += code == 0 ? 1 : 0;
    }
    CHECK(written >= 1);
    CHECK(fs::exists(runs / "out/run.json"));
    CHECK_FALSE(fs::exists(runs / "out/unfinished.json"));
    runs.check_unmixed();
  }
}

TEST_CASE("a run that is ended at any moment leaves no part of a file, and the next one works") {
  const Runs runs;
  xgm::Random random(3);
  const std::vector<int> windows{3, 5, 7, 9};
  const int moments = count_from("XGM_STRESS_MOMENTS", 9);
  for (int i = 0; i < moments; ++i) {
    const int signal = std::vector<int>{SIGINT, SIGTERM, SIGKILL}[static_cast<std::size_t>(i) % 3];
    CAPTURE(i);
    CAPTURE(signal);
    const std::string unfinished = runs / "out/unfinished.json";
    const bool was_unfinished = fs::exists(unfinished);
    const pid_t child = begin(runs, windows[static_cast<std::size_t>(i) % windows.size()]);
    std::this_thread::sleep_for(runs.duration * random.real(0, 1));
    ::kill(child, signal);
    const int code = end_of(child);
    CHECK((code == 0 || code == 128 + signal));
    if (fs::exists(runs / "out")) runs.check_unmixed();
    // One that a killed run has left stays until a run begins to write.
    if (signal != SIGKILL && !was_unfinished) CHECK_FALSE(fs::exists(unfinished));
  }
  CHECK(runs.call(Runs::arguments(3, "out")).exit_code == 0);
  CHECK(fs::exists(runs / "out/run.json"));
  runs.check_unmixed();
}

TEST_CASE("a folder in use is named in the error, with what to do") {
  const Runs runs;
  const Outcome outcome = runs.call(Runs::arguments(3, "out"), "mkdir out && flock out ");
  CAPTURE(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.errors,
                 "error: another run or bench writes to out; wait for it, or give another"));
  CHECK(fs::is_empty(runs / "out"));
}

TEST_CASE("a full disk is one error, and no part of a file is left") {
  const Runs runs;
  const std::string mounted =
      "unshare -rm sh -c 'mkdir -p out && mount -t tmpfs -o size=24k tmpfs out || exit 99; "
      "\"$@\"; code=$?; ls -A out; exit $code' sh ";
  const Outcome outcome = runs.call(Runs::arguments(3, "out"), mounted);
  if (!contains(outcome.errors, "No space left") && outcome.exit_code != 0) {
    std::cout << "SKIPPED: a full disk needs a file system that this user may mount" << std::endl;
    return;
  }
  CAPTURE(outcome.errors);
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.errors.find("error:") == outcome.errors.rfind("error:"));
  CHECK(contains(outcome.errors, "out/disparity.pfm: cannot be written: No space left on device"));
  CHECK(outcome.output == "unfinished.json\n");
}

TEST_CASE("a file that outgrows what is allowed is one error, and no part of it is left") {
  const Runs runs;
  const Outcome outcome = runs.call(Runs::arguments(3, "out"), "ulimit -f 10 && ");
  CAPTURE(outcome.errors);
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.errors, "out/disparity.pfm: cannot be written: File too large"));
  runs.check_unmixed();
  CHECK(runs.call(Runs::arguments(3, "out")).exit_code == 0);
}
