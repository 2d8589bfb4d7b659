// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/imc_mission.h"
#include "runtime/board/dialect.h"
#include "runtime/imc/backseat.h"

#include <new>

extern "C" const GliderImcMission gliderImc;

glider::runtime::FrameLine glider::runtime::framesOver(const GliderByteStream& line,
                                                       const LinkFacts* checkpoint) {
  // It lives as long as the program: no exit handler.
  alignas(imc::Backseat) static uint8_t memory[sizeof(imc::Backseat)];
  auto* backseat = ::new (memory) imc::Backseat(
      gliderMission, gliderImc, {.stream = line, .renew = nullptr, .self = nullptr}, checkpoint);
  return {backseat->stream(), backseat->damaged()};
}
