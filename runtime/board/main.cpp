// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The program of a mission on an SBC. Static memory only; uses only what Linux 2.4 provides.

#include "hooks/transport/system_clock.h"
#include "runtime/board/arithmetic.h"
#include "runtime/board/card.h"
#include "runtime/board/checkpoints.h"
#include "runtime/board/dialect.h"
#include "runtime/board/files.h"
#include "runtime/board/kernel.h"
#include "runtime/board/line.h"
#include "runtime/board/modem_line.h"
#include "runtime/board/own_line.h"
#include "runtime/board/parameters.h"
#include "runtime/core/runtime.h"

namespace glider::runtime {
namespace {

int fly(GliderRuntime* runtime, const Options& options, OpenPort& line, Card& card) {
  static hooks::SystemClock system_clock;
  const GliderClock clock = system_clock.clock();
  while (true) {
    serveModem(*runtime, clock);
    switch (gliderRuntimePoll(runtime, &line.stream, &clock)) {
      case kGliderRuntimeIdle:
        if (const int* own = ownDescriptor(); own != nullptr) {
          line.descriptor = *own;
          card.setLine(*own);
        }
        card.rested(runtime->virtualTime());
        if (runtime->fallsAsleep()) {
          sleepBoard(options);
        }
        if (!waitForBoth(line.descriptor)) {
          waitForLine(line.descriptor);
        }
        break;
      case kGliderRuntimeProgressed:
        break;
      case kGliderRuntimeFinished:
        if (mayEnd()) {
          return kDone;
        }
        break;
      case kGliderRuntimeLinkClosed:
        tell("error: the line to the vehicle is closed");
        return kNoLink;
      case kGliderRuntimeFailed:
        return tellFailedCheck();
    }
  }
}

OpenPort openTheLine(const Options& options) {
  OpenPort own;
  return openOwnLine(own) ? own : openLine(options);
}

int run(const Options& options) {
  if (!areFilesApart(options)) {
    return kWrongUse;
  }
  static Launch launch(gliderMission);
  if (!setParameters(options, launch)) {
    return kBadParameters;
  }
  // Before the line is opened, so that the card's process does not hold it open.
  static Card card;
  (void)card.start(
      {openLogOf(options), openCheckpoints(options.checkpoints, gliderMission.context_bytes),
       holdCheckpoints, reopenLog},
      gliderMission.context_bytes);
  OpenPort line = openTheLine(options);
  if (line.problem != nullptr) {
    return kNoLink;
  }
  card.setLine(line.descriptor);
  if (const int status = openModemLine(options); status != kDone) {
    return status;
  }
  alignas(GliderRuntime) static uint8_t memory[sizeof(GliderRuntime)];
  const GliderRuntimeOptions runtime_options{card.log(), launch.values(), card.checkpoints(),
                                             programNumber()};
  GliderRuntime* runtime =
      gliderRuntimeInit(memory, gliderContextMemory, &gliderMission, &runtime_options);
  if (runtime == nullptr) {
    tell("error: this mission was made for another runtime");
    return kWrongUse;
  }
  const FrameLine frames = framesOver(line.stream, runtime->checkpoint());
  line.stream = frames.stream;
  runtime->countDamageBy(frames.damaged);
  runtime->afterTick(frames.after_tick);
  return fly(runtime, options, line, card);
}

}  // namespace
}  // namespace glider::runtime

int main(int argc, char** argv) {
  using namespace glider::runtime;
  holdStandardFiles();
  useDoublePrecision();
  ignoreSignal(SIGPIPE);
  const Options options = readOptions(takeModemOptions(takeOwnLine(argc, argv), argv), argv);
  if (options.wish == Options::Wish::Fly) {
    return run(options);
  }
  const int status = tellWish(options, gliderMission.name);
  if (options.wish == Options::Wish::Help) {
    tellOwnLine();
    tellModemOptions();
    tellParameters(gliderMission);
  }
  return status;
}
