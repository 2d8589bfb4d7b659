// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/replay/replay.h"

#include "simulator/replay/agreeing_vehicle.h"

#include <memory>

namespace glider::simulator {
namespace {

/// The cycles in which a handshake must have been made.
constexpr int kMostHandshakeCycles = 20;

ReplayAnswer answerOf(const AgreeingVehicle& vehicle, double mission_time) {
  ReplayAnswer answer;
  const hooks::SbcView view = vehicle.sbc();
  answer.answered = view.known && view.mission_time_s == mission_time;
  answer.state = view.state;
  answer.stack_depth = view.stack_depth;
  answer.finished = vehicle.finished();
  return answer;
}

}  // namespace

std::vector<ReplayAnswer> replay(const platforms::Platform& platform, SbcPort& sbc,
                                 const std::vector<ReplayTick>& ticks) {
  // Too large for a stack: the queues of hooks are arrays.
  const auto vehicle = std::make_unique<AgreeingVehicle>(platform, sbc);
  std::vector<ReplayAnswer> answers;
  for (int i = 0; i < kMostHandshakeCycles && !vehicle->sbc().known; ++i) {
    vehicle->floatAtSurface();
  }
  vehicle->floatAtSurface();  // for an SBC that has told what it subscribes to
  for (int i = 0; i < kMostHandshakeCycles && !vehicle->askedForControl(); ++i) {
    vehicle->offerControl(ticks.front());
  }
  if (!vehicle->askedForControl()) {
    return answers;
  }
  answers.push_back(answerOf(*vehicle, 0));
  for (size_t i = 1; i < ticks.size() && !vehicle->finished() && sbc.alive(); ++i) {
    vehicle->tick(ticks[i]);
    answers.push_back(answerOf(*vehicle, ticks[i].mission_time));
  }
  return answers;
}

}  // namespace glider::simulator
