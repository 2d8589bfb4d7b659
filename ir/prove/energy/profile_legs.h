// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/profile_modes.h"
#include "ir/prove/abstract/timer_guards.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/energy/depth_condition.h"
#include "ir/prove/energy/depth_span.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace glider::ir::prove {

/// A climb to this depth or deeper does not come to the surface, m; and a vehicle that has not been
/// deeper has not dived, so that it does not surface (Vehicle of the simulator).
inline constexpr double kUnderWater_m = 3;

/// Which way a command about depth drives the vehicle.
enum class Drive : uint8_t {
  Down,
  Up,
  Hover,
  Anywhere  ///< pump and battery may be commanded at any time, or the command is not known
};

/// A part of a state's time in which its profile's command stays the same.
struct ProfileLeg {
  Drive drive = Drive::Anywhere;
  std::optional<Command> command = {};  ///< with which it drives: always the same
  DepthSpan target;                     ///< of what is commanded, m; all depths if it is not known
  bool turns_there = true;  ///< the profile commands another way at the target at the latest
};

/// A case that waits for a time since the profile last set a variable, s.
struct TimerWait {
  VariableId since;
  double least_s = 0;
};

/// A way from one leg to the next.
struct LegTurn {
  size_t from = 0, to = 0;
  DepthSpan where;
  /// What else is known of where it is: by limits that stay the same while the state is current.
  std::vector<DepthCondition> limits;
  std::vector<TimerWait> waits;
  std::vector<VariableId> sets;  ///< timers that it certainly sets
};

/// The legs of a state by its profile.
struct ProfileLegs {
  std::vector<ProfileLeg> legs;
  std::vector<size_t> first;  ///< those with which it may begin, or go on after a return
  std::vector<LegTurn> turns;
  double steepest_rad = 0;  ///< the greatest pitch that is commanded
};

/// What the search in each state of a mission uses.
struct LegContext {
  /// `known`: a context in which the depth is known (ProofContext::withDepthKnown); it outlives
  /// this.
  explicit LegContext(const ProofContext& known);
  LegContext(const LegContext&) = delete;
  LegContext& operator=(const LegContext&) = delete;

  const ProofContext& seen;
  std::vector<Interval> held;  ///< of every expression
  Valuation values;            ///< any
  TimerGuards guards;
};

/// A profile whose
/// commands cannot be followed (in C, with many truth values, or beside other commands about depth)
/// is one leg that drives anywhere; so is a leg by a command whose target or pitch may change.
ProfileLegs legsOf(const LegContext& context, StateId state);

}  // namespace glider::ir::prove
