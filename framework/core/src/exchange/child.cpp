// SPDX-License-Identifier: Apache-2.0
#include "exchange/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <sstream>
#include <thread>
#include <utility>

#include "xgm/base/error.hpp"

extern char** environ;  // POSIX has no header for it

namespace xgm::exchange {
namespace {

namespace fs = std::filesystem;

/// Both ends are closed in programs that are started meanwhile, and when this is gone.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) {
      throw Error(std::string("no program can be started: ") + std::strerror(errno));
    }
  }
  ~Pipe() {
    for (const int end : ends_) {
      if (end >= 0) ::close(end);
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reading() const { return ends_[0]; }
  int writing() const { return ends_[1]; }
  void close_writing() {
    ::close(ends_[1]);
    ends_[1] = -1;
  }
  int take_reading() { return std::exchange(ends_[0], -1); }

 private:
  std::array<int, 2> ends_{-1, -1};
};

struct Start {
  const char* program;
  char* const* words;
  int output, failure;  ///< ends of pipes to write to
  std::optional<rlim_t> memory;
  pid_t parent;
};

/// Becomes the program. Only what is safe after a fork in a process of several threads.
[[noreturn]] void become(const Start& start) {
  ::setpgid(0, 0);
  for (int number = 1; number < NSIG; ++number) ::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // should this process be killed itself
  if (::getppid() != start.parent) ::_exit(1);
  const int input = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  bool good = ::dup2(input, STDIN_FILENO) >= 0 && ::dup2(start.output, STDOUT_FILENO) >= 0 &&
              ::dup2(start.output, STDERR_FILENO) >= 0;
  ::close_range(STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC);
  if (start.memory) {
    const rlimit limit{*start.memory, *start.memory};
    good = good && ::setrlimit(RLIMIT_AS, &limit) == 0;
  }
  if (good) ::execve(start.program, start.words, environ);
  const int error = errno;
  [[maybe_unused]] const auto told = ::write(start.failure, &error, sizeof error);
  ::_exit(1);
}

/// All signals are held back meanwhile: one that reaches the child before it is itself would call
/// handlers of this process.
pid_t fork_into(const Start& start) {
  sigset_t all, former;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &former);
  const pid_t child = ::fork();
  if (child == 0) become(start);
  const int failure = errno;
  ::pthread_sigmask(SIG_SETMASK, &former, nullptr);
  errno = failure;
  return child;
}

/// Where a shell would find it.
std::string find_program(const std::string& name) {
  if (name.find('/') != std::string::npos) return name;
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder.empty() ? "." : folder) / name;
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0) return file;
  }
  throw Error("cannot be started: there is no such program in PATH; check 'command'");
}

}  // namespace

Child::Child(std::vector<std::string> words, double memory_bytes) {
  const std::string program = find_program(words.front());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  Pipe output, failure;
  std::optional<rlim_t> memory;
  if (memory_bytes > 0) memory = static_cast<rlim_t>(memory_bytes);
  id_ = fork_into(
      {program.c_str(), pointers.data(), output.writing(), failure.writing(), memory, ::getpid()});
  if (id_ < 0) throw Error(std::string("cannot be started: ") + std::strerror(errno));
  output.close_writing();
  failure.close_writing();
  int error = 0;  // the pipe is closed without a word when the program is the child
  if (::read(failure.reading(), &error, sizeof error) == sizeof error) {
    ::waitpid(id_, nullptr, 0);
    throw Error(std::string("cannot be started: ") + std::strerror(error) + "; check 'command'");
  }
  output_ = output.take_reading();
  ::fcntl(output_, F_SETFL, O_NONBLOCK);
}

Child::~Child() {
  end();
  if (output_ >= 0) ::close(output_);
}

std::string Child::read() const {
  constexpr int kPeriod = 20;  // ms
  pollfd waiting{output_, POLLIN, 0};
  if (::poll(&waiting, 1, kPeriod) <= 0) return {};
  std::array<char, 1 << 16> bytes;
  const ssize_t count = ::read(output_, bytes.data(), bytes.size());
  if (count > 0) return {bytes.data(), static_cast<std::size_t>(count)};
  // It has closed its output, and need not have ended: poll() would not wait any more.
  std::this_thread::sleep_for(std::chrono::milliseconds(kPeriod));
  return {};
}

bool Child::has_ended() const {
  siginfo_t info{};
  const int failure = ::waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT);
  return failure != 0 || info.si_pid == id_;
}

void Child::end() {
  if (id_ < 0) return;
  constexpr std::chrono::milliseconds kGrace{300}, kPeriod{5};
  ::kill(-id_, SIGTERM);
  const auto deadline = std::chrono::steady_clock::now() + kGrace;
  while (!has_ended() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(kPeriod);
  }
  status();
}

/// The group is ended first: as long as its leader has not been waited for, its number is nobody
/// else's.
int Child::status() {
  ::kill(-id_, SIGKILL);
  int status = 0;
  while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  id_ = -1;
  return status;
}

}  // namespace xgm::exchange
