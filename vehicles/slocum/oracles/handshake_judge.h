// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/oracles/judge_setup.h"
#include "vehicles/slocum/oracles/names.h"

#include <string>

namespace glider::slocum::oracles {

/// Checks that an SBC that asks for control while nothing is wrong gets an answer: without one it
/// would ask for the rest of the mission, and the vehicle would float.
class HandshakeJudge {
 public:
  explicit HandshakeJudge(const JudgeSetup& setup);

  /// The SBC sends a Take with these numbers.
  void asked(double session, double sequence, double now_s);
  /// What is violated in this cycle; empty: nothing.
  std::string cycle(const CycleView& view);

 private:
  [[nodiscard]] bool isAnswered(const CycleView& view) const;

  const JudgeSetup& s_;
  double last_fault_s_;  ///< when the last of the faults ends
  double session_ = 0, sequence_ = 0;
  double asked_s_ = -1e9;      ///< when it asked last
  double waits_since_s_ = -1;  ///< negative: it does not wait
};

}  // namespace glider::slocum::oracles
