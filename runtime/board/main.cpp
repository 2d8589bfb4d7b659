// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The program of a mission on an SBC. Static memory only; what it needs of the operating system,
// Linux 2.4 has.

#include "hooks/transport/system_clock.h"
#include "runtime/board/arithmetic.h"
#include "runtime/board/files.h"
#include "runtime/board/options.h"
#include "runtime/board/port.h"
#include "runtime/core/runtime.h"

#include <poll.h>
#include <signal.h>
#include <unistd.h>

namespace glider::runtime {
namespace {

constexpr int kDone = 0;
constexpr int kWrongUse = 1;
constexpr int kNoLink = 2;
/// Silence is counted in seconds: so long to sleep when no byte comes, ms.
constexpr int kNapMs = 1000;

template <typename... Pieces>
void tell(Pieces... pieces) {
  const char* const list[] = {pieces..., "\n", nullptr};
  say(list);
}

void help() {
  tell(
      "mission ", gliderMission.name,
      ": takes part in steering a glider over a serial line\n"
      "  --port PATH  the line to the science computer (else ",
      defaultPort(),
      ")\n"
      "  --baud N     its speed, bits/s (else 115200)\n"
      "  --stdio      standard input and output instead of a port\n"
      "  --log FILE   write the mission's log\n"
      "  --version    which mission and runtime this is\n"
      "status: 0 the mission ended and gave control back, 1 wrong use, 2 no port or its link lost");
}

OpenPort openLine(const Options& options) {
  if (options.stdio) {
    return {standardStream(), STDIN_FILENO, nullptr};
  }
  return openPort(options.port != nullptr ? options.port : defaultPort(), options.baud);
}

/// Sleeps until there are bytes, or the clock may have something to say. Ends soon also if poll
/// fails: then it has become a pause.
void wait(int descriptor) {
  pollfd wanted{descriptor, POLLIN, 0};
  if (poll(&wanted, 1, kNapMs) < 0) {
    (void)poll(nullptr, 0, 10);
  }
}

int fly(GliderRuntime& runtime, const OpenPort& line) {
  static hooks::SystemClock system_clock;
  const GliderClock clock = system_clock.clock();
  while (true) {
    switch (gliderRuntimePoll(&runtime, &line.stream, &clock)) {
      case kGliderRuntimeNothing:
        wait(line.descriptor);
        break;
      case kGliderRuntimeProgressed:
        break;
      case kGliderRuntimeFinished:
        return kDone;
      case kGliderRuntimeLinkClosed:
        tell("error: the line to the vehicle is closed");
        return kNoLink;
    }
  }
}

int run(const Options& options) {
  const OpenPort line = openLine(options);
  if (line.problem != nullptr) {
    tell("error: cannot open `", options.port != nullptr ? options.port : defaultPort(),
         "`: ", line.problem);
    return kNoLink;
  }
  GliderRuntimeOptions runtime_options{};
  if (options.log != nullptr) {
    runtime_options.log = openLog(options.log);
    if (runtime_options.log.write == nullptr) {
      tell("warning: cannot write the log `", options.log, "`; the mission flies without");
    }
  }
  alignas(GliderRuntime) static uint8_t memory[sizeof(GliderRuntime)];
  GliderRuntime* runtime =
      gliderRuntimeInit(memory, gliderContextMemory, &gliderMission, &runtime_options);
  if (runtime == nullptr) {
    tell("error: this mission was made for another runtime");
    return kWrongUse;
  }
  return fly(*runtime, line);
}

}  // namespace
}  // namespace glider::runtime

int main(int argc, char** argv) {
  using namespace glider::runtime;
  useDoublePrecision();
  signal(SIGPIPE, SIG_IGN);
  const Options options = readOptions(argc, argv);
  switch (options.wish) {
    case Options::Wish::Help:
      help();
      return kDone;
    case Options::Wish::Version:
      tell("mission ", gliderMission.name, ", glidercc runtime, ABI 1");
      return kDone;
    case Options::Wish::Wrong:
      tell("error: cannot make sense of `", options.wrong, "`; --help says what there is");
      return kWrongUse;
    case Options::Wish::Fly:
      return run(options);
  }
}
