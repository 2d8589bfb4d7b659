// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/interpreter.h"
#include "ir/prove/encoding/run.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::ir::prove {

struct ProofContext;

/// A tick as the vehicle causes it.
struct ConcreteTick {
  double mission_time = 0;
  std::vector<SensorUpdate> frame;  ///< raw; NaN: a reading that failed
  double depth = 0;                 ///< true depth, m; NaN: unknown
  StateId state;                    ///< current after the tick
  uint32_t stack_depth = 0;
  bool finished = false;
};

/// A counterexample tick by tick, as checked on the interpreter.
struct Counterexample {
  std::vector<double> parameters;
  std::vector<ConcreteTick> ticks;  ///< the start first
  struct Event {
    support::SourceRange range;  ///< of the case
    double mission_time = 0;
    std::string text;  ///< "at 500 s `s1` calls `s2`"
  };
  std::vector<Event> story;  ///< the transitions
  std::string state;         ///< the current one when the requirement is violated
  std::string values;        ///< "depth = 21 m": the values that a condition of `always` read then
  std::string words;         ///< how a requirement with a monitor is violated
  /// What it was due to, where that was earlier: "`depth > 5 m` was true at 20 s, in state `a`".
  std::string due;
  /// On the tick that starts the mission; without that tick nothing would be due.
  bool due_at_start = false;
  /// Numbers of cases of `always` that were true then and, by the rules, not tried.
  std::vector<uint32_t> held_back;
  double when = 0;         ///< mission time at which the requirement is violated (Reach: satisfied)
  size_t requirement = 0;  ///< which one of the requirements that were checked
};

/// Concretizes `run`: makes a tick in every flight cycle, with readings that let nothing fire
/// between its steps, and checks it on the interpreter. Empty if the interpreter does not follow
/// `run`: it is then possible only for the approximate terms.
std::optional<Counterexample> concretize(const Run& run, const ProofContext& proof_context,
                                         uint32_t stack_depth, const Requirement& requirement);

}  // namespace glider::ir::prove
