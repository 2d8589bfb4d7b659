// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/abstract_evaluator.h"

#include <vector>

namespace glider::ir::prove {

/// When a state has become current, mission times, s.
struct Arriving {
  double earliest = 0;
  double latest = 0;
};

/// For a part of the time of arrival, which is examined apart.
struct LeavingPart {
  Arriving arriving;
  double by = 0;  ///< as Leaving::by
  bool at_once =
      false;  ///< one of the state's own cases leads away on the first tick that tries them
};

/// The latest times at which a state's own cases fire, by the clocks; mission times, s.
struct Leaving {
  double by = 0;  ///< some case, of its own or of `always`, has led away; infinite: nothing is
                  ///< certain to end the state
  /// For each case: it does not fire on a later tick, because one before it has certainly led away.
  std::vector<double> latest;
  double interrupted = 0;  ///< no case of `always` fires on a later tick; negative: none ever does
  std::vector<LeavingPart> parts = {};  ///< of the time of arrival, in order
  size_t looks = 0;                     ///< the number of moments examined
  size_t work = 0;                      ///< the number of expressions evaluated
};

/// A list of cases, or those of it that may fire.
using Cases = std::vector<const Case*>;

/// The cases of `always` that may interrupt a state.
struct Interruptions {
  Cases cases;
  bool own_first = false;  ///< on its first tick the state's own cases come before these
};

/// The times for `state`, if it became current between these times and its variables stay within
/// `values`, for any readings of the sensors.
///
/// If it may have become current both before and after a time that its guards compare mission time
/// with, these arrivals are examined apart: what must fire at once on a late one says nothing about
/// an early one, and what may still fire after an early one need not after a late one.
Leaving leavingOf(const ProofContext& proof_context, const State& state,
                  const Interruptions& always, const Valuation& values, const Arriving& arriving);

/// The same in seconds since the state became current, whenever that was.
/// With `idle`, if these temporals are never true, or never known.
Leaving stayOf(const ProofContext& proof_context, const State& state, const Interruptions& always,
               const Valuation& values, const IdleTemporals* idle = nullptr);

}  // namespace glider::ir::prove
