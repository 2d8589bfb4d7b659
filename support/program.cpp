// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/program.h"

#include "support/diagnostics/ids/command.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace glider::support {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
/// A temporary file without a name: a pipe could fill while the program fills the other one.
using Scratch = std::unique_ptr<std::FILE, Close>;

Scratch scratchWith(std::string_view content) {
  Scratch file(std::tmpfile());
  if (file && (std::fwrite(content.data(), 1, content.size(), file.get()) != content.size() ||
               std::fflush(file.get()) != 0 || std::fseek(file.get(), 0, SEEK_SET) != 0)) {
    file.reset();
  }
  return file;
}

std::string contentOf(std::FILE* file) {
  std::string text;
  std::array<char, 4096> part{};
  std::rewind(file);
  while (const size_t count = std::fread(part.data(), 1, part.size(), file)) {
    text.append(part.data(), count);
  }
  return text;
}

/// In the child between fork and exec: only calls that are safe there. `report` takes errno if exec
/// fails.
[[noreturn]] void becomeProgram(char* const* arguments, pid_t parent, int input, int output,
                                int report) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() == parent && ::dup2(input, STDIN_FILENO) >= 0 &&
      ::dup2(output, STDOUT_FILENO) >= 0) {
    ::execvp(arguments[0], arguments);
  }
  const int error = errno;
  [[maybe_unused]] const ssize_t told = ::write(report, &error, sizeof error);
  ::_exit(127);
}

int exitCodeOf(pid_t program) {
  int status = 0;
  while (::waitpid(program, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

pid_t startProgram(const std::vector<std::string>& command, int input, int output) {
  std::vector<char*> arguments;
  for (const std::string& argument : command) {
    arguments.push_back(const_cast<char*>(argument.c_str()));  // exec does not write to them
  }
  arguments.push_back(nullptr);
  std::array<int, 2> report{};
  if (::pipe2(report.data(), O_CLOEXEC) != 0) {
    return -1;
  }
  const pid_t parent = ::getpid();
  const pid_t pid = ::fork();
  if (pid == 0) {
    becomeProgram(arguments.data(), parent, input, output, report[1]);
  }
  int error = pid < 0 ? errno : 0;
  ::close(report[1]);
  ssize_t got = 0;
  while (pid > 0 && (got = ::read(report[0], &error, sizeof error)) < 0 && errno == EINTR) {
  }
  ::close(report[0]);
  if (pid > 0 && got > 0) {
    ::waitpid(pid, nullptr, 0);
  }
  errno = error;
  return error != 0 ? -1 : pid;
}

Result<ProgramOutput> runProgram(const std::vector<std::string>& command, std::string_view input) {
  const Scratch in = scratchWith(input);
  const Scratch out = scratchWith("");
  const pid_t program =
      in && out ? startProgram(command, ::fileno(in.get()), ::fileno(out.get())) : pid_t{-1};
  if (program < 0) {
    return fail(support::diagnostics::programNotStarted, command.front(), std::strerror(errno));
  }
  const int code = exitCodeOf(program);
  return ProgramOutput{contentOf(out.get()), code};
}

}  // namespace glider::support
