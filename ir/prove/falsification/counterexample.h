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

/// A tick as the vehicle would cause it.
struct ConcreteTick {
  double mission_time = 0;
  std::vector<SensorUpdate> frame;  ///< raw; NaN: a reading that failed
  double depth = 0;                 ///< true depth, m; NaN: nobody knows
  StateId state;                    ///< current after the tick
  uint32_t stack_depth = 0;
  bool finished = false;
};

/// A run tick by tick, as it was tried out on the interpreter.
struct Counterexample {
  std::vector<double> parameters;
  std::vector<ConcreteTick> ticks;  ///< the start first
  struct Event {
    support::SourceRange range;  ///< of the case
    double mission_time = 0;
    std::string text;  ///< "at 500 s `s1` calls `s2`"
  };
  std::vector<Event> story;  ///< the transitions
  std::string state;         ///< the current one when it is broken
  std::string values;        ///< "depth = 21 m": what a condition of `always` read then
  double when = 0;           ///< mission time at which the requirement is broken (Reach: kept)
  size_t requirement = 0;    ///< which one, of those that were looked for
};

/// Spells `run` out: a tick in every flight cycle, with readings that let nothing fire between its
/// steps, and tries it on the interpreter. Empty if that does not do what the run says: it is one
/// of the terms only.
std::optional<Counterexample> concretize(const Run& run, const ProofContext& proof_context,
                                         uint32_t stack_depth, const Requirement& requirement);

}  // namespace glider::ir::prove
