// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/ports/process_sbc_port.h"

#include "simulator/faults/card_damage.h"
#include "support/diagnostics/ids/ports.h"
#include "support/program.h"

#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace glider::simulator {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kSlice = 50;  // ms between checks whether the program still runs

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A program that reads and writes nothing but its serial line.
pid_t startSilently(const std::vector<std::string>& command) {
  const int nowhere = ::open("/dev/null", O_RDWR);
  if (nowhere < 0) {
    return -1;
  }
  const pid_t program = support::startProgram(command, nowhere, nowhere);
  const int error = errno;
  ::close(nowhere);
  errno = error;
  return program;
}

}  // namespace

support::Result<std::unique_ptr<ProcessSbcPort>> ProcessSbcPort::start(
    std::string way, std::vector<std::string> command, double hang_secs, std::filesystem::path card,
    std::unique_ptr<LineTurns> turns) {
  auto pty = hooks::Pty::open();
  if (!pty) {
    return std::unexpected(pty.error());
  }
  for (std::string& argument : command) {
    if (argument == "{port}") {
      argument = pty->name();
    }
  }
  if (command.empty()) {
    return support::fail(support::diagnostics::sbcNotStarted, "", "no program is named");
  }
  std::unique_ptr<ProcessSbcPort> port(
      new ProcessSbcPort(std::move(way), std::move(*pty), hang_secs, std::move(turns)));
  port->card_ = std::move(card);
  port->pid_ = startSilently(command);
  if (port->pid_ < 0) {
    return support::fail(support::diagnostics::sbcNotStarted, command.front(),
                         std::strerror(errno));
  }
  return port;
}

ProcessSbcPort::~ProcessSbcPort() {
  kill();
}

void ProcessSbcPort::reap(bool block, const std::string& killed) {
  if (pid_ <= 0) {
    return;
  }
  int status = 0;
  pid_t ended = 0;
  while ((ended = ::waitpid(pid_, &status, block ? 0 : WNOHANG)) < 0 && errno == EINTR) {
  }
  if (ended == 0) {
    return;
  }
  pid_ = 0;
  const bool by_us = !killed.empty() && WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  if (exit_reason_.empty()) {
    exit_reason_ = by_us               ? killed
                   : WIFEXITED(status) ? fmt::format("exited with status {}", WEXITSTATUS(status))
                                       : fmt::format("ended by signal {}", WTERMSIG(status));
  }
}

void ProcessSbcPort::destroy(const std::string& exit_reason) {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    reap(true, exit_reason);  // if it has just ended by itself, that is the exit reason
  }
}

void ProcessSbcPort::closed() {
  // A program that ends closes its port before its exit status is available. How long before
  // depends on the load of the machine, so the wait is as long as for an answer.
  constexpr useconds_t kPause = 2000;
  const auto start = Clock::now();
  for (reap(false); alive() && secondsSince(start) < hang_secs_; reap(false)) {
    ::usleep(kPause);
  }
  destroy("closed its serial port");
}

void ProcessSbcPort::kill() {
  if (alive()) {
    exit_reason_ = "killed";  // also if it has just ended by itself, which is not known yet
    ::kill(pid_, SIGKILL);
    reap(true);
  }
}

void ProcessSbcPort::damageCard(const CardFault& fault, uint64_t seed) {
  std::ifstream file(card_, std::ios::binary);
  if (card_.empty() || !file) {
    return;  // nothing is kept there
  }
  std::vector<uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
  glider::simulator::damageCard(fault, seed, bytes);
  std::ofstream(card_, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

void ProcessSbcPort::read() {
  std::array<uint8_t, 4096> bytes;
  const GliderByteStream stream = pty_.stream();
  int32_t count = 0;
  while ((count = stream.read(stream.self, bytes.data(), static_cast<uint32_t>(bytes.size()))) >
         0) {
    turns_->fromSbc(bytes.data(), static_cast<uint32_t>(count));
    received_.insert(received_.end(), bytes.begin(), bytes.begin() + count);
    if (!heard_) {
      heard_ = true;
      pty_.releaseUserSide();  // from now on the end of the program closes the line
    }
  }
  if (count < 0 && missed()) {
    closed();
  }
}

void ProcessSbcPort::wait(bool to_write, int milliseconds) {
  pollfd poll{pty_.descriptor(), static_cast<short>(POLLIN | (to_write ? POLLOUT : 0)), 0};
  ::poll(&poll, 1, milliseconds);
  read();
  if (missed()) {
    reap(false);
  }
}

void ProcessSbcPort::deliver(std::span<const uint8_t> bytes, double /*now_s*/) {
  const GliderByteStream stream = pty_.stream();
  auto last_progress = Clock::now();
  while (alive() && !bytes.empty()) {
    const int32_t taken =
        stream.write(stream.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
    if (taken < 0) {
      // The line is closed. This is detected by the missing answer to a whole frame, just as if the
      // program had taken a little longer to end.
      turns_->toSbc(bytes.data(), static_cast<uint32_t>(bytes.size()));
      return;
    }
    if (taken > 0) {
      turns_->toSbc(bytes.data(), static_cast<uint32_t>(taken));
      bytes = bytes.subspan(static_cast<size_t>(taken));
      last_progress = Clock::now();
    } else if (secondsSince(last_progress) > hang_secs_) {
      destroy("hung");
    } else {
      wait(true, kSlice);
    }
  }
}

std::vector<uint8_t> ProcessSbcPort::collect() {
  const auto start = Clock::now();
  while (alive() && !turns_->settled()) {
    if (secondsSince(start) > hang_secs_) {
      destroy("hung");
    } else {
      wait(false, kSlice);
    }
  }
  return std::exchange(received_, {});
}

}  // namespace glider::simulator
