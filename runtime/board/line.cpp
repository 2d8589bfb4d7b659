// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/line.h"

#include "runtime/board/files.h"

#include <fcntl.h>
#include <poll.h>
#include <string.h>
#include <unistd.h>

namespace glider::runtime {
namespace {

void tellHelp(const char* mission_name) {
  tell("mission ", mission_name,
       ": steers a glider over a serial line\n"
       "  --port PATH  the line to the science computer (else ",
       defaultPort(),
       ")\n"
       "  --baud N  its speed (115200)\n"
       "  --stdio  standard input and output\n"
       "  --log FILE  for `glidercc log`\n"
       "  --log-limit N  bytes; then it becomes FILE.old (32 MiB)\n"
       "  --checkpoint FILE  what a restart needs to go on\n"
       "  --set NAME=VALUE  a parameter: bottom=20m\n"
       "  --parameters FILE  the same, one a line\n"
       "  --sleep FILE  sleeps by `mem` to it, if the mission may (/sys/power/state)\n"
       "  --version\n"
       "status: 0 ended, 1 wrong use, 2 parameters, port or link, 3 internal check");
}

}  // namespace

const char* portOf(const Options& options) {
  return options.port != nullptr ? options.port : defaultPort();
}

int tellWish(const Options& options, const char* mission_name) {
  switch (options.wish) {
    case Options::Wish::Help:
      tellHelp(mission_name);
      return kDone;
    case Options::Wish::Version: {
      static_assert(GLIDER_ABI_VERSION >= 10 && GLIDER_ABI_VERSION < 100);
      const char abi[] = {static_cast<char>('0' + GLIDER_ABI_VERSION / 10),
                          static_cast<char>('0' + GLIDER_ABI_VERSION % 10), '\0'};
      tell("mission ", mission_name, ", glidercc runtime, ABI ", abi);
      return kDone;
    }
    case Options::Wish::Wrong:
    case Options::Wish::Fly:
      break;
  }
  tell("error: cannot make sense of `", options.wrong, options.wrong_value[0] != '\0' ? " " : "",
       options.wrong_value, "`; see --help");
  return kWrongUse;
}

int tellFailedCheck() {
  tell("error: an internal check failed; the log names it");
  return kCheckFailed;
}

bool areFilesApart(const Options& options) {
  if (options.log == nullptr || options.checkpoints == nullptr ||
      strcmp(options.log, options.checkpoints) != 0) {
    return true;
  }
  tell("error: --log and --checkpoint name the same file `", options.log, "`");
  return false;
}

OpenPort openLine(const Options& options) {
  if (options.stdio) {
    return {standardStream(), STDIN_FILENO, nullptr};
  }
  const OpenPort port = openPort(portOf(options), options.baud);
  if (port.problem != nullptr) {
    tell("error: cannot open `", portOf(options), "`: ", port.problem);
  }
  return port;
}

GliderLogSink openLogOf(const Options& options) {
  if (options.log == nullptr) {
    return {};
  }
  return openLog(options.log, options.log_limit);
}

void waitForLine(int descriptor) {
  pollfd wanted{descriptor, POLLIN, 0};
  if (poll(&wanted, 1, kNapMs) < 0) {
    (void)poll(nullptr, 0, 10);  // never spin, for any error that poll reports for the line
  }
}

}  // namespace glider::runtime
