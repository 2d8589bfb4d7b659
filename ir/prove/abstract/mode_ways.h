// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/profile_modes.h"
#include "ir/prove/abstract/timer_guards.h"
#include "ir/prove/context/proof_context.h"

#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace glider::ir::prove {

/// A way from a mode to one of those that a case's `do` leads to.
struct ModeWay {
  Mode to;
  size_t by = 0;  ///< the case
};

/// The modes of a profile, and the ways between them.
class ModeWays {
 public:
  /// Both outlive this.
  ModeWays(const ProofContext& proof_context, const Activity& profile);

  /// False if there are too many, or one of their truth values may be unknown, or is set by `done`.
  bool explore();

  [[nodiscard]] const ProfileModes& modes() const { return modes_; }
  [[nodiscard]] const std::map<Mode, std::vector<ModeWay>>& all() const { return ways_; }
  /// The modes in which the profile may go on when its state becomes current again.
  [[nodiscard]] std::set<Mode> resumed(const Mode& from) const;

 private:
  const GreatestFixpoint& known_;
  const Activity& profile_;
  ProfileModes modes_;
  std::map<Mode, std::vector<ModeWay>> ways_;
};

/// Whether anything else than the profile of the language commands a depth while the state is
/// current, or sets what the profile remembers.
bool othersInterfere(const Mission& mission, StateId state);

/// Variables of the state's profile that hold a time of the mission: never unknown, never in the
/// future.
std::vector<VariableId> timersOfProfile(const Mission& mission, const TimerGuards& guards,
                                        StateId state);

/// Whether a block sets the variable whenever it runs.
bool setsForSure(const Mission& mission, BlockId block, VariableId id);

}  // namespace glider::ir::prove
