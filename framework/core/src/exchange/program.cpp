// SPDX-License-Identifier: Apache-2.0
#include "xgm/exchange/program.hpp"

#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <cstring>

#include "exchange/child.hpp"
#include "exchange/printed.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/text.hpp"

namespace xgm::exchange {
namespace {

constexpr double kMegabyte = 1e6;
constexpr std::size_t kMostPrinted = 64'000'000;  // bytes

/// What it said last, which is most often the reason.
std::string last_words(const Printed& printed) {
  return printed.last().empty() ? "" : "; it said last: " + printed.last();
}

/// Waits for the end of the child, whose status it returns, or throws.
int wait(Child& child, const Program& program, Printed& printed, const Context& context) {
  using Seconds = std::chrono::duration<double>;
  const auto start = std::chrono::steady_clock::now();
  while (!child.has_ended()) {
    printed.take(child.read());
    context.throw_if_cancelled();
    if (printed.bytes() > kMostPrinted) {
      throw Error("printed more than " + bytes_text(double{kMostPrinted}) +
                  " and was ended; let it print less" + last_words(printed));
    }
    const Seconds taken = std::chrono::steady_clock::now() - start;
    if (taken.count() <= program.time_limit) continue;
    throw Error("did not end within " + short_number(program.time_limit) +
                " s and was ended; raise time_limit, if it takes longer" + last_words(printed));
  }
  const int status = child.status();
  for (std::string rest = child.read(); !rest.empty(); rest = child.read()) printed.take(rest);
  printed.finish();
  return status;
}

void require_success(int status, const Program& program, const Printed& printed) {
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    throw Error("was ended by signal " + std::to_string(number) + " (" + ::strsignal(number) + ")" +
                (number == SIGKILL || program.memory_limit > 0 ? "; was memory short?" : "") +
                last_words(printed));
  }
  if (WEXITSTATUS(status) == 0) return;
  throw Error("failed with exit code " + std::to_string(WEXITSTATUS(status)) + last_words(printed));
}

}  // namespace

void declare(Program& program, ParameterSet& set) {
  set.add("command", program.command,
          "The program and its arguments, which no shell reads; the path of request.json is added "
          "to them. A name without a slash is looked for in PATH, other relative paths from where "
          "the run was started.");
  set.add("time_limit", program.time_limit, "A program that takes longer is ended.")
      .unit("s")
      .range(0.01, 1e6);
  set.add("memory_limit", program.memory_limit,
          "Address space that each process of the program may take; 0: any.")
      .unit("MB")
      .range(0, 1e9);
  set.rule({"command"}, "must name a program",
           [&program] { return !program.command.empty() && !program.command.front().empty(); });
}

void run_program(const Program& program, const std::string& argument, const Context& context) {
  std::vector<std::string> words = program.command;
  words.push_back(argument);
  Printed printed(context);
  try {
    Child child(std::move(words), program.memory_limit * kMegabyte);
    require_success(wait(child, program, printed, context), program, printed);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    throw Error("the program '" + program.command.front() + "' " + error.message());
  }
}

}  // namespace xgm::exchange
