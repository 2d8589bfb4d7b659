// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// What a restarted program does with the newest checkpoint ("Checkpoints" of runtime/README.md).
namespace glider::runtime {

enum class Continuation : uint8_t {
  GoesOn,  ///< the mission continues
  Leaves,  ///< the mission is over: control is left to the vehicle
  Begins,  ///< the checkpoint is of an earlier flight: the mission may begin from the start
};

/// A checkpoint of an unfinished mission that is this old is of an earlier flight, s: by then the
/// `overtime` of the bundled mission files has ended the vehicle's own mission.
inline constexpr double kAnotherFlight = 12 * 3600.0;

struct Outage {
  bool restarted = false;  ///< the vehicle has restarted its own mission
  double length = 0;       ///< s; NaN: unknown; negative: a clock was set back
  bool finished = false;   ///< the mission had ended
  double resume_within = 0;
  bool never_after_restart = false;
  bool failed = false;  ///< a check of the program's own memory had failed
};

constexpr Continuation continuationAfter(const Outage& outage) {
  const bool within =
      !outage.failed && outage.length >= 0.0 && outage.length <= outage.resume_within;
  if (!outage.restarted) {
    return within ? Continuation::GoesOn : Continuation::Leaves;
  }
  if (!outage.finished && within && !outage.never_after_restart) {
    return Continuation::GoesOn;
  }
  return outage.finished || outage.length >= kAnotherFlight ? Continuation::Begins
                                                            : Continuation::Leaves;
}

}  // namespace glider::runtime
