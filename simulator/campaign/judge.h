// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/judge_id.h"
#include "simulator/faults/faults.h"
#include "simulator/flight_observer.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace glider::simulator {

/// A promise that a flight did not keep.
struct Violation {
  JudgeId judge = JudgeId::Ending;
  double at_s = 0;
  std::string what;
};

/// How a flight went.
struct Verdict {
  enum class Outcome : uint8_t {
    Exited,     ///< the mission ended and released control
    Released,   ///< the vehicle continued without the SBC, and is at the surface
    Violation,  ///< a promise was not kept
  };
  Outcome outcome = Outcome::Released;
  std::string violation;                   ///< the first that was seen
  double violation_s = 0;                  ///< when
  std::vector<Violation> violations = {};  ///< the first of each check, in order of time
  uint32_t releases = 0;                   ///< times that control was taken away from the SBC
  uint32_t instructions = 0;               ///< that were obeyed
  double end_s = 0;
  double deepest_m = 0;  ///< true depth
  double take_s = 0;     ///< when control was first taken; 0: never
  double release_s = 0;  ///< when it was released; 0: never
  double mean_W = 0;     ///< from the batteries
  Span hover = {0, 0};   ///< the longest
  /// The numbers (from 0) of the mission's requirements that the flight violated, in order. Faults
  /// may cause that, so it is not a violation of a promise.
  std::vector<size_t> requirements = {};
};

/// Checks a flight by what it observes, as the vehicle's family promises it.
class Judge : public FlightObserver {
 public:
  /// After the flight.
  [[nodiscard]] virtual Verdict verdict() const = 0;
};

}  // namespace glider::simulator
