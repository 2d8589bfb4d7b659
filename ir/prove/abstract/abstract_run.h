// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/abstract_evaluator.h"

#include <utility>

namespace glider::ir::prove {

/// The effect of statements and transitions on the values that variables may have.
class AbstractRun {
 public:
  explicit AbstractRun(const ProofContext& proof_context)
      : proof_context_(proof_context), m_(proof_context.mission) {}

  /// The start of the mission: parameters and the variables of the mission have their values, the
  /// variables of states do not.
  [[nodiscard]] Valuation begin() const;
  /// Runs a block; an invalid id does nothing.
  void execute(BlockId block, const ClockRanges& clocks, Valuation& values) const;
  /// Enters the target of `c`, which fires at `clocks`; `c` is null for the start of the mission.
  void enter(StateId state, const Case* c, const ClockRanges& clocks, Valuation& values) const;
  /// Resumes a state: its profile and route start again, its variables keep their values.
  void resume(StateId state, const ClockRanges& clocks, Valuation& values) const;
  /// Allows any value for what `block` sets.
  void forget(BlockId block, Valuation& values) const;
  /// The number of expressions evaluated since the last call.
  size_t takeWork() const { return std::exchange(work_, 0); }

 private:
  void start(uint32_t variable, const ClockRanges& clocks, Valuation& values) const;
  void set(const Statement& statement, const ClockRanges& clocks, Valuation& values) const;
  void branch(const Statement& statement, const ClockRanges& clocks, Valuation& values) const;

  const ProofContext& proof_context_;
  const Mission& m_;
  mutable size_t work_ = 0;
};

}  // namespace glider::ir::prove
