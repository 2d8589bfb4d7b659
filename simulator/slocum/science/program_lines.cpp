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

using Clock = std::chrono::steady_clock;
/// How long a program may need to end once its output is closed: so many times so many us.
constexpr int kEndingSlices = 100;
constexpr useconds_t kEndingSlice = 10000;

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

bool ProgramLines::wait(short events) {
  using std::chrono::milliseconds;
  for (;;) {
    const auto left = std::chrono::duration_cast<milliseconds>(until_ - Clock::now());
    pollfd poll{socket_, events, 0};
    const int ready = left > milliseconds(0) ? ::poll(&poll, 1, static_cast<int>(left.count())) : 0;
    if (ready > 0) {
      return true;
    }
    if (ready == 0) {
      trouble_ = fmt::format("it has not answered for {} s", kHangSecs);
      return false;
    }
    if (errno != EINTR) {
      return false;
    }
  }
}

bool ProgramLines::send(std::string_view lines) {
  until_ = Clock::now() + std::chrono::seconds(kHangSecs);
  received_ = 0;
  while (!lines.empty()) {
    const ssize_t sent = ::send(socket_, lines.data(), lines.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && errno != EINTR && (errno != EAGAIN || !wait(POLLOUT))) {
      return false;
    }
    lines.remove_prefix(sent < 0 ? 0 : static_cast<size_t>(sent));
  }
  return true;
}

bool ProgramLines::receive(std::string& line) {
  for (;;) {
    if (received_ > kMostAnswer) {
      trouble_ = "its answer has no end";
      return false;
    }
    if (const size_t end = unread_.find('\n'); end != std::string::npos) {
      line = unread_.substr(0, end);
      unread_.erase(0, end + 1);
      return true;
    }
    std::array<char, 4096> part{};
    const ssize_t got = wait(POLLIN) ? ::recv(socket_, part.data(), part.size(), 0) : 0;
    if (got <= 0) {
      return false;
    }
    received_ += static_cast<size_t>(got);
    unread_.append(part.data(), static_cast<size_t>(got));
  }
}

std::string ProgramLines::trouble() {
  if (!trouble_.empty() || pid_ <= 0) {
    return trouble_;
  }
  // It has closed its output: it ends, or should.
  int status = 0;
  for (int i = 0; i < kEndingSlices && ::waitpid(pid_, &status, WNOHANG) == 0; ++i) {
    if (i + 1 == kEndingSlices) {
      return "it has closed its output, and goes on";
    }
    ::usleep(kEndingSlice);
  }
  pid_ = 0;
  return WIFEXITED(status) ? fmt::format("it ended with status {}", WEXITSTATUS(status))
                           : fmt::format("it was ended by signal {}", WTERMSIG(status));
}

}  // namespace glider::simulator
