// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/science/program_lines.h"

#include "support/program.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace glider::simulator {
namespace {

constexpr size_t kLongestLine = 1U << 16U;

}  // namespace

std::unique_ptr<ProgramLines> ProgramLines::start(const std::vector<std::string>& command,
                                                  std::string& why) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    why = std::strerror(errno);
    return nullptr;
  }
  const pid_t pid = support::startProgram(command, ends[1], ends[1]);
  why = pid < 0 ? std::strerror(errno) : "";
  ::close(ends[1]);
  if (pid < 0) {
    ::close(ends[0]);
    return nullptr;
  }
  return std::unique_ptr<ProgramLines>(new ProgramLines(pid, ends[0]));
}

ProgramLines::~ProgramLines() {
  ::close(socket_);
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
}

bool ProgramLines::send(std::string_view lines) {
  while (!lines.empty()) {
    const ssize_t sent = ::send(socket_, lines.data(), lines.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno != EINTR) {
      return false;
    }
    lines.remove_prefix(sent < 0 ? 0 : static_cast<size_t>(sent));
  }
  return true;
}

bool ProgramLines::receive(std::string& line) {
  for (;;) {
    if (const size_t end = unread_.find('\n'); end != std::string::npos) {
      line = unread_.substr(0, end);
      unread_.erase(0, end + 1);
      return true;
    }
    pollfd poll{socket_, POLLIN, 0};
    const int ready = ::poll(&poll, 1, kHangSecs * 1000);
    if (ready < 0 && errno == EINTR) {
      continue;
    }
    std::array<char, 4096> part{};
    const ssize_t got = ready > 0 ? ::recv(socket_, part.data(), part.size(), 0) : 0;
    hung_ = ready == 0 || unread_.size() > kLongestLine;
    if (got <= 0 || hung_) {
      return false;
    }
    unread_.append(part.data(), static_cast<size_t>(got));
  }
}

std::string ProgramLines::trouble() {
  if (hung_ || pid_ <= 0) {
    return fmt::format("it has not answered for {} s", kHangSecs);
  }
  int status = 0;
  ::kill(pid_, SIGTERM);  // it has closed its output: it ends, or should
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = 0;
  return WIFEXITED(status) ? fmt::format("it ended with status {}", WEXITSTATUS(status))
                           : fmt::format("it was ended by signal {}", WTERMSIG(status));
}

}  // namespace glider::simulator
