// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// No mission is meant to be as long: a year, s.
inline constexpr double kLongestMission = 365 * 86400.0;

/// What is waited for.
enum class Goal : uint8_t {
  Exit,
  ExitOrSurface,  ///< also a state whose profile commands the surface as it is entered
};

/// When it has come, for the first time.
struct EndBound {
  std::optional<double> by;  ///< mission time, s; none: none up to the time that was asked
  /// With `by`, of each state: after this mission time, s, it is not current any more; 0: it never
  /// is.
  std::vector<double> left_by;
  StateId stays;  ///< without `by`: a state in which a run may stay beyond `latest`; invalid: the
                  ///< search was given up
};

/// A mission time (s) by which every run has come to `goal`; none if none up to `latest` is found.
///
/// Every call stack that a run can have is looked at, with what its variables may hold, and the
/// latest time at which it can become current. A state is left for sure once a case of its own that
/// leads away must be true, by the clocks alone; and a tick comes within ProofContext::tick_gap_s.
/// No solver: a mission that counts its legs, or stops at a chosen set of depths, is bounded here
/// where Spacer, which seeks an invariant over sums of times, gives up.
EndBound boundOf(const ProofContext& proof_context, double latest, Goal goal);

/// By when a mission has ended: one search, however many ask.
class Ending {
 public:
  /// `proof_context` outlives this.
  explicit Ending(const ProofContext& proof_context) : proof_context_(proof_context) {}

  /// Of the mission's exit, looked for up to kLongestMission.
  const EndBound& bound();
  /// The same for an SBC whose power is never cut.
  const EndBound& boundWithoutPowerCuts();
  /// What boundOf(proof_context, latest, Goal::Exit) finds.
  std::optional<double> by(double latest);

 private:
  const ProofContext& proof_context_;
  std::optional<EndBound> bound_;  ///< none: not looked for yet
  std::optional<EndBound> without_power_cuts_;
};

}  // namespace glider::ir::prove
