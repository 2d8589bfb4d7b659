// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/port_mission.h"
#include "runtime/board/dialect.h"
#include "runtime/extctl/backseat.h"
#include "runtime/extctl/coming_up.h"

#include <new>

extern "C" const GliderPortMission gliderPort;

namespace {

glider::runtime::extctl::Backseat* the_backseat = nullptr;

}  // namespace

glider::runtime::FrameLine glider::runtime::framesOver(const GliderByteStream& line,
                                                       const LinkFacts* checkpoint) {
  // It lives as long as the program: no exit handler.
  alignas(extctl::Backseat) static uint8_t memory[sizeof(extctl::Backseat)];
  auto* backseat =
      ::new (memory) extctl::Backseat(gliderMission, gliderPort, line, {.checkpoint = checkpoint});
  static extctl::ComingUp coming_up(backseat->comesUpFor());
  the_backseat = backseat;
  return {backseat->stream(), backseat->damaged(), coming_up.afterTick()};
}

bool glider::runtime::mayEnd() {
  return the_backseat->mayEnd();
}
