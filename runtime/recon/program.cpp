// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/recon_mission.h"
#include "runtime/board/dialect.h"
#include "runtime/recon/backseat.h"

#include <new>

extern "C" const GliderReconMission gliderRecon;

namespace {

glider::runtime::recon::Backseat* backseat = nullptr;

}  // namespace

glider::runtime::FrameLine glider::runtime::framesOver(const GliderByteStream& line,
                                                       const LinkFacts* checkpoint) {
  // It lives as long as the program: no exit handler.
  alignas(recon::Backseat) static uint8_t memory[sizeof(recon::Backseat)];
  backseat = ::new (memory) recon::Backseat(gliderMission, gliderRecon, line, checkpoint);
  return {backseat->stream(), backseat->damaged(), backseat->afterTick()};
}

bool glider::runtime::mayEnd() {
  return backseat->mayEnd();
}
