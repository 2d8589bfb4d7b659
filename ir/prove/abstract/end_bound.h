// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/leaving.h"
#include "ir/prove/context/control.h"
#include "ir/prove/context/proof_context.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// Longer than any mission is meant to be: a year, s.
inline constexpr double kLongestMission = 365 * 86400.0;

/// The event to be bounded.
enum class Goal : uint8_t {
  Exit,
  ExitOrSurface,  ///< also a state whose profile commands the surface as it is entered
};

/// The upper bound of the time of its first occurrence.
struct EndBound {
  std::optional<double> by;  ///< mission time, s; none: no bound up to the given time
  /// With `by`, for each state: after this mission time, s, it is no longer current; 0: it never
  /// is.
  std::vector<double> left_by;
  /// Without `by`: the state whose own clock conditions bound no stay in it; invalid: the search
  /// was given up, or it is `loop` that has no bound.
  StateId stays = {};
  /// Without `by`: states that follow one another again and again, each left in a bounded time; in
  /// the order of the mission.
  std::vector<StateId> loop = {};
};

/// A mission time (s) by which every trace has reached `goal`; none if no bound up to `latest` is
/// found.
///
/// Every call stack that a trace can have is examined, with the values that its variables may have
/// and the latest time at which it can become current. A state has certainly been left once a case
/// of its own that leads away must be true, by the clocks alone; and a tick comes within
/// ProofContext::tick_gap_s. No solver is used: this bounds a mission that counts its legs, or
/// stops at a chosen set of depths, where Spacer, which looks for an invariant over sums of times,
/// gives up.
EndBound boundOf(const ProofContext& proof_context, double latest, Goal goal);

/// A case that ends a stay, and the stay that follows.
struct StayWay {
  ListKind list = ListKind::State;  ///< of the case, or always
  uint32_t number = 0;              ///< in its list
  std::optional<size_t> to;         ///< the number of a stay; none: the mission ends
  auto operator<=>(const StayWay&) const = default;
};

/// A state that has become current in a call configuration, with the values that the variables may
/// have while it is.
struct Stay {
  Control control;
  Valuation values;
  std::vector<LeavingPart> parts;  ///< when it becomes current, and until when it is
  std::vector<StayWay> ways;
  bool first = false;  ///< the mission starts with it
};

/// What the bound of the mission's exit rests on: every stay of every trace is one of these. Empty
/// if no bound up to kLongestMission is found.
std::vector<Stay> staysOf(const ProofContext& proof_context);

/// The time by which a mission has ended: one search, even if several callers ask.
class Ending {
 public:
  /// `proof_context` outlives this.
  explicit Ending(const ProofContext& proof_context) : proof_context_(proof_context) {}

  /// For the mission's exit, up to kLongestMission.
  const EndBound& bound();
  /// The same for an SBC whose power is never cut.
  const EndBound& boundWithoutPowerCuts();
  /// The result of boundOf(proof_context, latest, Goal::Exit).
  std::optional<double> by(double latest);

 private:
  const ProofContext& proof_context_;
  std::optional<EndBound> bound_;  ///< none: not looked for yet
  std::optional<EndBound> without_power_cuts_;
};

}  // namespace glider::ir::prove
