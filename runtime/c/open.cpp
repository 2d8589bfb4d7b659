// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/system_clock.h"
#include "runtime/board/arithmetic.h"
#include "runtime/board/card.h"
#include "runtime/board/checkpoints.h"
#include "runtime/board/files.h"
#include "runtime/board/kernel.h"
#include "runtime/board/line.h"
#include "runtime/board/options.h"
#include "runtime/c/glider.h"
#include "runtime/c/program.h"

#include <stdlib.h>

namespace {

int line_descriptor = -1;

glider::runtime::Card& card() {
  static glider::runtime::Card the_card;
  return the_card;
}

int waitForBytes() {
  card().rested(glider::runtime::Program::instance().virtualTime());
  glider::runtime::waitForLine(line_descriptor);
  return 1;
}

}  // namespace

extern "C" int gliderOpen(int argc, char** argv, const char* mission_name) {
  using namespace glider::runtime;
  static glider::hooks::SystemClock clock;
  holdStandardFiles();
  useDoublePrecision();
  ignoreSignal(SIGPIPE);
  mission_name = mission_name != nullptr ? mission_name : "";
  const Options options = readOptions(argc, argv);
  if (options.wish != Options::Wish::Fly) {
    const int status = tellWish(options, mission_name);
    if (status == kDone) {
      exit(kDone);  // 0 would mean that the link is open
    }
    return status;
  }
  if (options.setting_count > 0 || options.parameters != nullptr) {
    tell("error: a mission in C has no parameters");
    return kBadParameters;
  }
  if (!areFilesApart(options)) {
    return kWrongUse;
  }
  if (options.checkpoints != nullptr && !Program::instance().kept().isDeclared()) {
    tell("error: --checkpoint: `", mission_name,
         "` has not said what it must know to go on: it has no keepState (glidercc-runtime(3))");
    return kWrongUse;
  }
  (void)card().start(
      {openLogOf(options), openCheckpoints(options.checkpoints, Program::kMostContextBytes),
       holdCheckpoints, reopenLog},
      Program::kMostContextBytes);
  const OpenPort line = openLine(options);
  if (line.problem != nullptr) {
    return kNoLink;
  }
  line_descriptor = line.descriptor;
  card().setLine(line_descriptor);
  Program::instance().attach({line.stream, clock.clock(), waitForBytes, mission_name, card().log(),
                              card().checkpoints(), programNumber()});
  return kDone;
}
