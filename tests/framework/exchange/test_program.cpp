// SPDX-License-Identifier: Apache-2.0
// Programs of others: whatever they do, a run goes on or ends with one error, and nothing is left.
#include <doctest/doctest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/exchange/program.hpp"

using namespace xgm;
using namespace xgm::testing;
using exchange::Program;

namespace {

/// A script that is given the argument of the request as $1.
Program shell(const std::string& script) { return {{"sh", "-c", script, "sh"}, 20, 0}; }

std::string error_of_program(const Program& program, const Context& context = {}) {
  return error_of([&] { exchange::run_program(program, "argument", context); });
}

struct Log final : Observer {
  std::vector<std::string> lines, warnings;
  void log(LogLevel level, const StagePlace&, const std::string& text) override {
    (level == LogLevel::warning ? warnings : lines).push_back(text);
  }
};

double seconds_of(const std::function<void()>& body) {
  const auto start = std::chrono::steady_clock::now();
  body();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Whether it runs. Orphans that have ended wait for the system's first process to notice.
bool is_alive(pid_t id) {
  std::ifstream file("/proc/" + std::to_string(id) + "/stat");
  std::string line;
  std::getline(file, line);
  const std::size_t state = line.rfind(") ");
  return state != std::string::npos && line[state + 2] != 'Z';
}

/// Whether the process whose number the file holds is gone, soon.
bool is_gone(const std::string& file) {
  pid_t id = 0;
  std::ifstream(file) >> id;
  REQUIRE(id > 1);
  for (int i = 0; i < 100; ++i) {
    if (!is_alive(id)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

}  // namespace

TEST_CASE(
    "a program is given its words and the request, no input, and tells its lines to the log") {
  const TemporaryFolder folder;
  Log log;
  const Program program{
      {"sh", "-c", "echo \"$1|$2|$3\"; echo $(cat | wc -c) >&2; printf 'bar 1\\rbar 2\\n\\n'", "sh",
       "a b", "$HOME; *"},
      20,
      0};
  exchange::run_program(program, folder / "request.json", Context(&log));
  CHECK(log.lines == std::vector<std::string>{"a b|$HOME; *|" + (folder / "request.json"), "0",
                                              "bar 1", "bar 2"});
  CHECK(log.warnings.empty());
}

TEST_CASE("a program that fails is one error, with its last words") {
  CHECK(error_of_program(shell("exit 3")) == "the program 'sh' failed with exit code 3");
  CHECK(error_of_program(shell("echo some; echo no weights here >&2; echo; exit 1")) ==
        "the program 'sh' failed with exit code 1; it said last: no weights here");
  CHECK(error_of_program(shell("kill -SEGV $$")) ==
        "the program 'sh' was ended by signal 11 (Segmentation fault)");
  CHECK(contains(error_of_program(shell("kill -KILL $$")), "was memory short?"));
}

TEST_CASE("a program that cannot be started is one error that says why") {
  const TemporaryFolder folder;
  const std::string text = folder.write("text", "no program");
  CHECK(contains(error_of_program({{"no_such_program_xgm"}, 20, 0}), "no such program in PATH"));
  CHECK(contains(error_of_program({{folder / "missing"}, 20, 0}), "No such file or directory"));
  CHECK(contains(error_of_program({{text}, 20, 0}), "Permission denied"));
  std::filesystem::permissions(text, std::filesystem::perms::owner_all);
  CHECK(contains(error_of_program({{text}, 20, 0}), "Exec format error"));
}

TEST_CASE("a program that hangs is ended with all that it has started") {
  const TemporaryFolder folder;
  const std::string id = folder / "id", child = folder / "child";
  Program program = shell("echo $$ > " + id + "; trap '' TERM; sleep 1000 & echo $! > " + child +
                          "; echo waiting; wait; sleep 1000");
  program.time_limit = 0.4;
  std::string error;
  CHECK(seconds_of([&] { error = error_of_program(program); }) < 3);
  CHECK(error ==
        "the program 'sh' did not end within 0.4 s and was ended; raise time_limit, if it takes "
        "longer; it said last: waiting");
  CHECK(is_gone(id));
  CHECK(is_gone(child));
}

TEST_CASE("what a program leaves running when it ends is ended, too") {
  const TemporaryFolder folder;
  const std::string child = folder / "child";
  const double seconds =
      seconds_of([&] { CHECK(error_of_program(shell("sleep 1000 & echo $! > " + child)) == ""); });
  CHECK(seconds < 5);
  CHECK(is_gone(child));
}

TEST_CASE("a program that prints much fills no log, and one that prints without end is ended") {
  Log log;
  exchange::run_program(shell("i=0; while [ $i -lt 5000 ]; do echo line $i; i=$((i+1)); done"), "",
                        Context(&log));
  CHECK(log.lines.size() == 200);
  CHECK(log.lines.back() == "line 199");
  REQUIRE(log.warnings.size() == 1);
  CHECK(contains(log.warnings[0], "printed 5000 lines; the log has the first 200"));
  Log flooded;
  const std::string error = error_of_program({{"yes"}, 60, 0}, Context(&flooded));
  CHECK(contains(error, "printed more than 64 MB and was ended"));
  CHECK(contains(error, "it said last: argument"));
  CHECK(flooded.lines.size() == 200);
  Log one_line;
  exchange::run_program(shell("head -c 100000 /dev/zero | tr '\\0' 'x'"), "", Context(&one_line));
  REQUIRE(one_line.lines.size() == 1);
  CHECK(one_line.lines[0].size() == 500);
}

TEST_CASE("a program that closes its output may go on working") {
  const TemporaryFolder folder;
  const std::string done = folder / "done";
  exchange::run_program(shell("exec >/dev/null 2>&1; sleep 0.2; echo yes > " + done), "", {});
  CHECK(std::filesystem::exists(done));
}

TEST_CASE("a run that is cancelled ends its program within a second") {
  const TemporaryFolder folder;
  const std::string id = folder / "id";
  std::stop_source stop;
  const std::jthread canceller([&] {
    while (!std::filesystem::exists(id)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop.request_stop();
  });
  const Program program = shell("trap '' TERM; echo $$ > " + id + "; sleep 1000; sleep 1000");
  const double seconds = seconds_of([&] {
    CHECK_THROWS_AS(exchange::run_program(program, "", Context(nullptr, stop.get_token())),
                    Cancelled);
  });
  CHECK(seconds < 2);  // the script's start included
  CHECK(is_gone(id));
}

#ifndef XGM_SANITIZED
TEST_CASE("a program that takes more memory than it may fails") {
  Program program = shell("a=x; while true; do a=\"$a$a\"; done");
  program.memory_limit = 200;
  const std::string error = error_of_program(program);
  INFO(error);
  CHECK(contains(error, "the program 'sh'"));
  CHECK_FALSE(contains(error, "did not end"));
  CHECK(error_of_program(shell("exit 0")) == "");
}
#endif

TEST_CASE("programs of several runs do not wait for each other") {
  std::vector<std::jthread> runs;
  const double seconds = seconds_of([&] {
    for (int i = 0; i < 4; ++i) {
      runs.emplace_back([] { exchange::run_program(shell("sleep 0.5"), "", {}); });
    }
    runs.clear();
  });
  CHECK(seconds < 1.5);
}
