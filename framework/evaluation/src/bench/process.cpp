// SPDX-License-Identifier: Apache-2.0
// Child processes: what a run does to memory, or dies of, stays its own.
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <iterator>
#include <thread>

#include "xgm/base/error.hpp"
#include "xgm/evaluation/bench_process.hpp"
#include "xgm/io/file.hpp"

extern char** environ;  // POSIX has no header for it

namespace xgm {
namespace {

volatile sig_atomic_t noted_signal = 0;
constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};
struct sigaction former_actions[std::size(kSignals)];

void note_signal(int number) { noted_signal = number; }

/// Becomes another program; reads nothing, and writes all to `log`. Only what is safe after a fork
/// in a program of several threads.
[[noreturn]] void become(const char* program, char* const* words, const char* log, pid_t parent,
                         const sigset_t& signals) {
  constexpr int kMode = 0644;
  constexpr int kNotFound = 127;
  for (const int number : kSignals) {
    struct sigaction action {};
    ::sigaction(number, nullptr, &action);
    if (action.sa_handler == note_signal) ::signal(number, SIG_DFL);
  }
  ::sigprocmask(SIG_SETMASK, &signals, nullptr);
  // Also when this process is killed: a run that goes on alone would disturb the next bench.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kNotFound);
  const int input = ::open("/dev/null", O_RDONLY);
  const int output = ::open(log, O_WRONLY | O_CREAT | O_TRUNC, kMode);
  if (::dup2(input, STDIN_FILENO) < 0 || ::dup2(output, STDOUT_FILENO) < 0 ||
      ::dup2(output, STDERR_FILENO) < 0) {
    ::_exit(kNotFound);
  }
  for (const int file : {input, output}) {
    if (file > STDERR_FILENO) ::close(file);
  }
  ::execve(program, words, environ);
  ::_exit(kNotFound);
}

pid_t spawn(const std::string& program, std::vector<std::string> words, const std::string& log) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t parent = ::getpid();
  // A signal that reaches the child before it is itself must not be noted there, and lost.
  sigset_t all, former;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &former);
  const pid_t child = ::fork();
  if (child == 0) become(program.c_str(), pointers.data(), log.c_str(), parent, former);
  const int failure = errno;
  ::pthread_sigmask(SIG_SETMASK, &former, nullptr);
  if (child < 0) {
    throw Error(std::string("the program cannot be started: ") + std::strerror(failure));
  }
  return child;
}

/// Its wait status. Ends the child if this process is told to end.
int wait_for(pid_t child) {
  constexpr std::chrono::milliseconds kPeriod{5};
  int status = 0;
  bool told = false;
  while (true) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) return status;
    if (ended < 0 && errno != EINTR) {
      throw Error(std::string("a run cannot be waited for: ") + std::strerror(errno));
    }
    if (Interruptible::signal() != 0 && !told) {
      ::kill(child, SIGTERM);
      told = true;
    }
    std::this_thread::sleep_for(kPeriod);
  }
}

/// The last line that the program marked as an error; "" if there is none.
std::string last_error(const std::string& log) {
  std::string text;
  try {
    text = read_file(log);
  } catch (const Error&) {
    return {};  // it had nothing to say
  }
  // Located diagnostics have their place first.
  const std::string mark = "error: ";
  const std::size_t found = text.rfind(mark);
  if (found == std::string::npos) return {};
  const std::size_t line = text.rfind('\n', found) + 1;
  const std::size_t begin = line == found ? found + mark.size() : line;
  return text.substr(begin, text.find('\n', found) - begin);
}

std::string failure_of(int status, const std::string& log) {
  const std::string error = last_error(log);
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    return std::string("ended by signal ") + std::to_string(number) + " (" + ::strsignal(number) +
           ")" + (number == SIGKILL ? "; was memory short?" : "") +
           (error.empty() ? "" : "; " + error);
  }
  if (WEXITSTATUS(status) == 0) return {};
  return error.empty() ? "exit code " + std::to_string(WEXITSTATUS(status)) + "; see " + log
                       : error;
}

}  // namespace

Interruptible::Interruptible() {
  noted_signal = 0;
  struct sigaction action {};
  action.sa_handler = note_signal;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < std::size(kSignals); ++i) {
    ::sigaction(kSignals[i], nullptr, &former_actions[i]);
    // What nohup ignores stays ignored.
    if (former_actions[i].sa_handler != SIG_IGN) ::sigaction(kSignals[i], &action, nullptr);
  }
}

Interruptible::~Interruptible() {
  for (std::size_t i = 0; i < std::size(kSignals); ++i) {
    ::sigaction(kSignals[i], &former_actions[i], nullptr);
  }
}

int Interruptible::signal() { return noted_signal; }

RunOutcome run_program(const std::string& program, const std::vector<std::string>& words,
                       const std::string& log) {
  if (Interruptible::signal() != 0) return {.interrupted = true, .failure = {}};
  const int status = wait_for(spawn(program, words, log));
  const std::string failure = failure_of(status, log);
  // A run that ended well before the signal could reach it is done.
  if (Interruptible::signal() != 0 && !failure.empty()) return {.interrupted = true, .failure = {}};
  return {.interrupted = false, .failure = failure};
}

}  // namespace xgm
