// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/against/guard_reads.h"
#include "analysis/against/log_ticks.h"
#include "compiler/compilation.h"
#include "report/findings/against.h"

#include <span>
#include <vector>

namespace glider::analysis {

/// A case of a mission, with what its guard reads.
struct WatchedCase {
  ir::ListKind list = ir::ListKind::State;
  ir::StateId state;  ///< invalid for `always`
  uint32_t number = 0;
  GuardReads reads;
};

/// The cases of a mission that its author wrote: not those of the standard library's profiles and
/// routes.
std::vector<WatchedCase> watchedCases(const compiler::Checked& checked);
const ir::Case& caseOf(const ir::Mission& mission, const WatchedCase& watched);

/// Lets a case fire once while its guard remains true.
class FiringOnce {
 public:
  /// The guard in the next tick.
  void look(bool is_true) {
    fired_ = fired_ && is_true;
    is_true_ = is_true;
  }
  /// Whether it is true and the case has not fired since it became true.
  [[nodiscard]] bool due() const { return is_true_ && !fired_; }
  void fire() { fired_ = true; }

 private:
  bool is_true_ = false;
  bool fired_ = false;
};

/// A tick as a moment of the report.
report::LoggedMoment momentOf(const LogTicks& log, uint32_t tick);

/// The guard of every case on every tick. For each state, the mission starts there with the first
/// tick and stays there: cases that would leave it never fire, all others do as usual, so that the
/// variables that they set are right. The parameters of a state have the values that the
/// first transition to it would give them at the start. A case fires once while its guard remains
/// true, and not on a tick on which an earlier case that stays fires.
std::vector<report::LoggedCase> evaluateGuards(const compiler::Checked& checked,
                                               const LogTicks& log,
                                               std::span<const double> parameters);

/// The firings that follow one another too fast.
std::vector<report::Flicker> flickersOf(const std::vector<report::LoggedFiring>& firings);

}  // namespace glider::analysis
