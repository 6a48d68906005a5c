// SPDX-License-Identifier: Apache-2.0
#include "run_apart.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "xgm/base/error.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/text.hpp"

namespace xgm::testing {
namespace {

constexpr const char* kEnd = "";  // the last line, which tells an end from a sudden exit()

void write_line(int file, const std::string& text) {
  const std::string line = text + '\n';
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t written = ::write(file, line.data() + done, line.size() - done);
    if (written < 0 && errno != EINTR) ::_exit(1);  // nobody listens any more
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

[[noreturn]] void work_as_child(const std::function<void(const Tell&)>& work, int output) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  limit_memory(available_memory());
  work([output](const std::string& line) { write_line(output, line); });
  write_line(output, kEnd);
  ::_exit(0);
}

/// What the child writes, line by line.
class Lines {
 public:
  Lines(int file, double seconds) : file_(file), milliseconds_(static_cast<int>(1000 * seconds)) {}

  enum class Read { line, end, late };
  Read next(std::string& line) {
    std::size_t end = 0;
    while ((end = text_.find('\n')) == std::string::npos) {
      pollfd wanted{file_, POLLIN, 0};
      const int ready = ::poll(&wanted, 1, milliseconds_);
      if (ready == 0) return Read::late;
      std::array<char, 4096> buffer;
      const ssize_t count = ready < 0 ? -1 : ::read(file_, buffer.data(), buffer.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return Read::end;
      text_.append(buffer.data(), static_cast<std::size_t>(count));
    }
    line = text_.substr(0, end);
    text_.erase(0, end + 1);
    return Read::line;
  }

 private:
  int file_;
  int milliseconds_;
  std::string text_;
};

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string death(int status) {
  if (!WIFSIGNALED(status)) {
    return "it ended the process with exit code " + std::to_string(WEXITSTATUS(status));
  }
  const int number = WTERMSIG(status);
  return "signal " + std::to_string(number) + " (" + ::strsignal(number) + ")";
}

}  // namespace

std::string run_apart(const std::function<void(const Tell&)>& work, const Tell& take,
                      double seconds) {
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) throw Error("no pipe can be made; too many files are open");
  const pid_t child = ::fork();
  if (child < 0) throw Error(std::string("no process can be started: ") + std::strerror(errno));
  if (child == 0) {
    ::close(pipe[0]);
    work_as_child(work, pipe[1]);
  }
  ::close(pipe[1]);
  Lines lines(pipe[0], seconds);
  std::string line;
  bool ended_well = false;
  Lines::Read read = Lines::Read::line;
  while (!ended_well && (read = lines.next(line)) == Lines::Read::line) {
    ended_well = line == kEnd;
    if (!ended_well) take(line);
  }
  if (read == Lines::Read::late) ::kill(child, SIGKILL);
  const int status = wait_for(child);
  ::close(pipe[0]);
  if (read == Lines::Read::late) return "it takes longer than " + short_number(seconds) + " s";
  return ended_well ? "" : death(status);
}

}  // namespace xgm::testing
